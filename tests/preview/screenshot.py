#!/usr/bin/env python3
"""Makes the manual's picture of `durer watch`, docs/src/pictures/watch.png.

    python3 tests/preview/screenshot.py DURER SCENE OUT.png
"""

import pathlib
import shutil
import subprocess
import sys
import time

from selenium import webdriver
from selenium.webdriver.chrome.service import Service
from selenium.webdriver.common.action_chains import ActionChains
from selenium.webdriver.common.by import By

durer, scene, out = sys.argv[1:]
scene = pathlib.Path(scene).resolve()
watch = [str(pathlib.Path(durer).resolve()), "watch", scene.name, "--size", "560x420"]
process = subprocess.Popen(watch, cwd=scene.parent, stderr=subprocess.PIPE, text=True)
address = next(line for line in process.stderr if line.startswith("http")).split()[0]
options = webdriver.ChromeOptions()
for word in ["--headless=new", "--no-sandbox", "--disable-gpu", "--window-size=1020,850"]:
    options.add_argument(word)
driver = webdriver.Chrome(options=options, service=Service(shutil.which("chromedriver")))
try:
    driver.get(address)
    while driver.execute_script("return !told || told.status !== 'done' || !done"):
        time.sleep(0.1)
    stage = driver.find_element(By.ID, "stage")
    ActionChains(driver).move_to_element_with_offset(stage, -60, 40).perform()
    time.sleep(1)
    driver.save_screenshot(out)
finally:
    driver.quit()
    process.kill()
