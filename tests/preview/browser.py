#!/usr/bin/env python3
"""`durer watch` in a real browser: Chromium, headless, driven by selenium (PyPI).

    python3 tests/preview/browser.py DURER [FOLDER]

Screenshots go to FOLDER, if one is named. Ends with 1 at the first thing that is not as it should be.
"""

import http.client
import json
import pathlib
import shutil
import subprocess
import sys
import tempfile
import time
import urllib.parse

from selenium import webdriver
from selenium.webdriver.common.action_chains import ActionChains
from selenium.webdriver.common.by import By
from selenium.webdriver.common.keys import Keys
from selenium.webdriver.chrome.service import Service

SCENE = """#version 3.7;
global_settings { assumed_gamma 1 }
#include "colour.inc"
camera { location <0, 1, -4> look_at 0 angle 40 }
light_source { <-4, 6, -5> rgb 1 }
sphere { <clock, 0, 0>, 1
  pigment { Colour }
  finish { ambient 0.2 }
}
plane { y, -1 pigment { checker rgb 0.8 rgb 0.6 } }
#debug "hello from the scene\\n"
"""


class Preview:
    def __init__(self, durer, folder, *options):
        self.folder = pathlib.Path(folder)
        self.scene = self.folder / "ball.scene"
        self.write("colour.inc", "#declare Colour = pigment { rgb <1, 0, 0> }\n")
        self.write("ball.scene", SCENE)
        command = [durer, "watch", "ball.scene", "--size", "320x240", *options]
        self.process = subprocess.Popen(command, cwd=folder, stderr=subprocess.PIPE, text=True)
        self.address = self.process.stderr.readline().split()[0]

    def write(self, name, text):
        (self.folder / name).write_text(text)

    def end(self):
        self.process.kill()
        self.process.wait()


def browser():
    options = webdriver.ChromeOptions()
    for word in ["--headless=new", "--no-sandbox", "--disable-gpu", "--window-size=1280,900", "--disable-dev-shm-usage"]:
        options.add_argument(word)
    options.set_capability("goog:loggingPrefs", {"browser": "ALL"})
    return webdriver.Chrome(options=options, service=Service(shutil.which("chromedriver")))


def until(what, true, seconds=20):
    """Waits, and tells how long it took."""
    start, last = time.time(), None
    while time.time() - start < seconds:
        try:
            last = true()
            if last:
                return time.time() - start
        except Exception as error:  # The page may be loading.
            last = error
        time.sleep(0.02)
    sys.exit(f"not within {seconds} s: {what} ({last!r})")


def check(what, true):
    print(("ok    " if true else "WRONG ") + what, flush=True)
    if not true:
        sys.exit(1)


class Page:
    def __init__(self, driver, shots):
        self.driver, self.shots = driver, shots

    def js(self, text, *values):
        return self.driver.execute_script(f"return {text}", *values)

    def text(self, name):
        return self.js("document.getElementById(arguments[0]).textContent", name)

    def size(self):
        return self.js("[picture.width, picture.height]")

    def color(self, x, y):
        return self.js("Array.from(picture.getContext('2d').getImageData(arguments[0], arguments[1], 1, 1).data)", x, y)

    def run(self):
        return self.js("[run, done, state.status]")

    def settle(self, after=0):
        return until("a finished picture", lambda: self.run()[0] > after and self.run()[1] and self.run()[2] == "done")

    def shot(self, name):
        if self.shots:
            self.driver.save_screenshot(str(pathlib.Path(self.shots) / f"{name}.png"))


def ask(address, path=None, method="GET", body=None, **headers):
    """The status of a request of somebody else. Headers with `_` for `-`; one that is None is left out."""
    url = urllib.parse.urlsplit(address)
    connection = http.client.HTTPConnection(url.hostname, url.port, timeout=10)
    connection.putrequest(method, path if path is not None else url.path, skip_host=True)
    for name, value in {"Host": url.netloc, **{name.replace("_", "-"): value for name, value in headers.items()}}.items():
        if value is not None:
            connection.putheader(name, value)
    if body is not None:
        connection.putheader("Content-Length", str(len(body)))
    connection.endheaders(body)
    answer = connection.getresponse()
    text = answer.read() if method != "HEAD" else b""
    return answer.status, text, dict(answer.getheaders())


def refusals(address):
    path = urllib.parse.urlsplit(address).path
    check("the page itself is served", ask(address)[0] == 200)
    refused = {
        "another Host": dict(Host="evil.example"),
        "no Host": dict(Host=None),
        "another Origin": dict(Origin="http://evil.example"),
        "an Origin that hides": dict(Origin="null"),
        "another site's script": dict(Sec_Fetch_Site="cross-site"),
        "no token": dict(path="/"),
        "a wrong token": dict(path="/" + "0" * 32 + "/"),
        "a path outside": dict(path="/../../etc/passwd"),
    }
    for what, how in refused.items():
        status, text, _ = ask(address, **how)
        check(f"refused: {what}", status == 403 and b"<" not in text and b"root:" not in text)
    for what in ["../ball.scene", "ball.scene", "%2e%2e/ball.scene", "/etc/passwd", "page.css/../../ball.scene"]:
        check(f"not there: {what}", ask(address, path + what)[0] == 404)
    check("another method", ask(address, path + "change")[0] == 404)
    check("no JSON", ask(address, path + "change", "POST", b"{")[0] == 400)
    check("unknown settings", ask(address, path + "change", "POST", b'{"evil": 1}')[0] == 400)
    check("a body too long", ask(address, path + "change", "POST", None, Content_Length="9999999")[0] == 400)
    headers = ask(address)[2]
    check("nobody frames it", "frame-ancestors 'none'" in headers["Content-Security-Policy"])
    check("nobody learns its address", headers["Referrer-Policy"] == "no-referrer")


def pictures(page, preview):
    driver = page.driver
    start = time.time()
    driver.get(preview.address)
    until("a picture", lambda: page.run()[0] == 1)
    page.settle()
    print(f"      first picture {time.time() - start:.2f} s after the page was asked for")
    check("it is as large as it should be", page.size() == [320, 240])
    red = page.color(160, 110)
    check(f"the ball is red {red}", red[0] > 120 and red[1] < 30 and red[3] == 255)
    check("what the scene prints is shown", "hello from the scene" in page.text("log"))
    check("times are shown", "picture" in page.text("times") and "rays" in page.text("times"))
    page.shot("light-wide")

    last = page.run()[0]
    start = time.time()
    preview.write("colour.inc", "#declare Colour = pigment { rgb <0, 0, 1> }\n")
    until("another picture", lambda: page.run()[0] > last)
    begun = time.time() - start
    page.settle(last)
    print(f"      after an included file was saved: begun in {begun:.3f} s, done in {time.time() - start:.3f} s")
    blue = page.color(160, 110)
    check(f"an included file was saved: the ball is blue {blue}", blue[2] > 120 and blue[0] < 30)

    compare = driver.find_element(By.ID, "compare")
    check("there is a picture of before", compare.is_enabled())
    driver.execute_script("arguments[0].value = 50; arguments[0].dispatchEvent(new Event('input'))", compare)
    old = page.js("Array.from(before.getContext('2d').getImageData(160, 110, 1, 1).data)")
    check(f"the slider shows it {old}", old[0] > 120 and page.js("!before.hidden && before.style.clipPath") == "inset(0px 50% 0px 0px)")
    page.shot("compare")
    driver.execute_script("arguments[0].value = 0; arguments[0].dispatchEvent(new Event('input'))", compare)


def messages(page, preview):
    last = page.run()[0]
    preview.write("ball.scene", SCENE.replace("sphere", "spere"))
    until("a message", lambda: "spere" in page.text("messages"))
    check("the status tells of it", "error" in page.text("status"))
    check("the picture of before stays", page.color(160, 110)[2] > 120 and page.run()[0] == last)
    link = page.js("document.querySelector('#messages a').href")
    check(f"its place is a link {link}", link.startswith("vscode://file/") and link.endswith("ball.scene:6:1"))
    page.shot("message")
    preview.scene.unlink()
    until("the file is missed", lambda: "E0002" in page.text("messages"))
    preview.write("ball.scene", SCENE.replace("<clock, 0, 0>", "<clock, 0, 0>, // \xe9"))
    preview.write("ball.scene", SCENE)
    page.settle()
    until("the message is gone", lambda: page.text("messages") == "None.")
    check("a file that was deleted is back", True)
    preview.write("ball.scene", SCENE + '#include "later.inc"\n')
    until("a file is missed", lambda: "later.inc" in page.text("messages"))
    preview.write("later.inc", "sphere { 0, 0.1 pigment { rgb 1 } }\n")
    until("a file that was missed has come", lambda: page.text("messages") == "None.")
    check("a file that was missed has come", True)
    preview.write("ball.scene", SCENE)
    until("the scene is as it was", lambda: page.run()[1] and page.run()[2] == "done")


def pointer(page, preview):
    driver, stage = page.driver, page.driver.find_element(By.ID, "stage")
    box = page.js("(({width, height}) => [width, height])(picture.getBoundingClientRect())")
    to = lambda x, y: (int((x / 320 - 0.5) * box[0]), int((y / 240 - 0.5) * box[1]))
    ActionChains(driver).move_to_element_with_offset(stage, *to(160, 110)).perform()
    until("what is picked", lambda: "sphere at ball.scene:6:1" in page.text("pick"))
    words = page.text("pick")
    check("point, normal and colour are told", all(word in words for word in ["point", "normal", "colour", "distance"]))
    ActionChains(driver).move_to_element_with_offset(stage, *to(20, 230)).perform()
    until("what is picked", lambda: "plane at ball.scene:10:1" in page.text("pick"))
    right = page.js("pointer[0]")
    stage.send_keys(Keys.ARROW_RIGHT)
    moved = lambda: page.text("pick").startswith(f"{right + 1}, ")
    until("the keys move", lambda: moved() and page.js("!document.getElementById('cross').hidden"))
    ActionChains(driver).move_to_element_with_offset(stage, *to(160, 110)).click().perform()
    opened = preview.folder / "opened"
    until("the editor is opened", lambda: opened.exists() and opened.read_text().split()[-2:] == ["6", "1"])
    check("a click opens the line", opened.read_text().split()[0].endswith("ball.scene"))

    last = page.run()[0]
    drag = ActionChains(driver).move_to_element_with_offset(stage, *to(120, 80)).click_and_hold()
    drag.move_to_element_with_offset(stage, *to(200, 140)).perform()
    check("a frame is drawn", page.js("!document.getElementById('frame').hidden"))
    page.shot("frame")
    ActionChains(driver).release().perform()
    page.settle(last)
    size = page.size()
    check(f"its part is drawn large {size}", abs(size[0] - 320) <= 8 and abs(size[1] - 240) <= 8)
    middle = page.color(size[0] // 2, size[1] // 2)
    check(f"it shows the ball {middle}", middle[2] > 100 and middle[0] < 40)
    page.shot("region")
    last = page.run()[0]
    driver.find_element(By.TAG_NAME, "body").send_keys(Keys.ESCAPE)
    page.settle(last)
    check("Escape shows all of it", page.size() == [320, 240])


def controls(page, preview):
    driver = page.driver
    body = lambda: driver.find_element(By.TAG_NAME, "body")
    last, before = page.run()[0], page.color(110, 110)
    clock = driver.find_element(By.ID, "clock")
    driver.execute_script("arguments[0].value = 1; arguments[0].dispatchEvent(new Event('input'))", clock)
    page.settle(last)
    check("the clock moves the ball", page.color(100, 110) != before and page.color(235, 110)[2] > 100)
    for step in range(60):
        driver.execute_script("arguments[0].value = arguments[1]; arguments[0].dispatchEvent(new Event('input'))", clock, step / 60)
    driver.execute_script("arguments[0].value = 0; arguments[0].dispatchEvent(new Event('input'))", clock)
    until("the last value", lambda: page.run()[1:] == [True, "done"] and page.js("state.clock[0]") == 0)
    check("dragging ends where it ends", page.color(160, 110)[2] > 120)

    last = page.run()[0]
    body().send_keys("4")
    page.settle(last)
    check("twice as large", page.size() == [640, 480])
    last = page.run()[0]
    body().send_keys("3")
    page.settle(last)
    last = page.run()[0]
    body().send_keys("a")
    page.settle(last)
    check("no anti-aliasing", page.js("state.settings.antialias") is False)
    last = page.run()[0]
    body().send_keys("a")
    page.settle(last)
    last = page.run()[0]
    driver.execute_script("const q = document.getElementById('quality'); q.value = 0; q.dispatchEvent(new Event('change'))")
    page.settle(last)
    check("quality 0 has no light", page.color(160, 110)[2] == 255)
    driver.execute_script("const q = document.getElementById('quality'); q.value = 9; q.dispatchEvent(new Event('change'))")
    page.settle(last + 1)

    check("nothing was written", not (preview.folder / "ball.png").exists())
    driver.find_element(By.ID, "save").click()
    until("a file", lambda: "ball.png" in page.text("saved"))
    drawn = preview.folder / "drawn.png"
    subprocess.run([preview.durer, "-q", "render", "ball.scene", "--size", "320x240", "--clock", "0", "-o", "drawn.png"], cwd=preview.folder, check=True)
    check("the button writes what `durer render` does", drawn.read_bytes() == (preview.folder / "ball.png").read_bytes())

    driver.refresh()
    page.settle()
    until("the picture of before", lambda: driver.find_element(By.ID, "compare").is_enabled())
    check("after a reload all is there", page.color(160, 110)[2] > 120 and page.size() == [320, 240])


def saves(page, preview):
    last = page.run()[0]
    start = time.time()
    for i in range(1000):
        preview.write("colour.inc", f"#declare Colour = pigment {{ rgb <0, {i / 1000}, 1> }}\n")
        time.sleep(0.004)
    preview.write("colour.inc", "#declare Colour = pigment { rgb <0, 1, 0> }\n")
    until("the last of a thousand saves", lambda: page.color(160, 110)[1] > 120 and page.color(160, 110)[2] < 30)
    print(f"      a thousand saves in {time.time() - start:.1f} s, {page.run()[0] - last} pictures begun")
    status = pathlib.Path(f"/proc/{preview.process.pid}/status")
    if status.exists():
        memory = next(line for line in status.read_text().splitlines() if line.startswith("VmRSS"))
        print("      " + " ".join(memory.split()))
        check("its memory stays small", int(memory.split()[1]) < 400_000)


def looks(page):
    page.driver.execute_cdp_cmd("Emulation.setEmulatedMedia", {"features": [{"name": "prefers-color-scheme", "value": "dark"}]})
    time.sleep(0.3)
    dark = page.js("getComputedStyle(document.body).backgroundColor")
    check(f"dark where the author wants it {dark}", dark == "rgb(27, 28, 30)")
    page.shot("dark-wide")
    page.driver.set_window_size(420, 900)
    time.sleep(0.3)
    check("narrow: nothing is cut off", page.js("document.documentElement.scrollWidth <= document.documentElement.clientWidth"))
    page.shot("dark-narrow")
    page.driver.execute_cdp_cmd("Emulation.setEmulatedMedia", {"features": [{"name": "prefers-color-scheme", "value": "light"}]})
    page.shot("light-narrow")
    unnamed = page.js("[...document.querySelectorAll('button,input,select')].filter(e => !e.textContent.trim() && !e.labels?.length && !e.ariaLabel).map(e => e.id)")
    check(f"all that can be used has a name {unnamed}", unnamed == [])


def main():
    durer = shutil.which(sys.argv[1]) or sys.argv[1]
    durer = str(pathlib.Path(durer).resolve())
    shots = sys.argv[2] if len(sys.argv) > 2 else None
    with tempfile.TemporaryDirectory() as folder:
        editor = pathlib.Path(folder) / "editor.sh"
        editor.write_text('#!/bin/sh\necho "$1 $2 $3" > opened\n')
        editor.chmod(0o755)
        preview = Preview(durer, folder, "--editor", f"{editor} {{file}} {{line}} {{column}}")
        preview.durer = durer
        driver = browser()
        try:
            page = Page(driver, shots)
            refusals(preview.address)
            pictures(page, preview)
            messages(page, preview)
            pointer(page, preview)
            controls(page, preview)
            saves(page, preview)
            looks(page)
            errors = [entry for entry in driver.get_log("browser") if entry["level"] == "SEVERE"]
            check(f"the browser has nothing to complain of {errors}", not errors)
            preview.end()
            until("its end is told", lambda: "ended" in page.text("status"))
        finally:
            driver.quit()
            preview.end()


main()
