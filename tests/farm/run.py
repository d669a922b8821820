#!/usr/bin/env python3
"""Renders a picture in 8 shards by real schedulers, and compares the merged picture with that of one process.

    run.py --durer target/release/durer [--only slurm]

In each, one shard is killed and started again, and one is started twice. Schedulers that are not installed are skipped
by name: GNU parallel, Open Job Description (`openjd`, package openjd-cli of PyPI), HyperQueue (package hyperqueue of PyPI), and
Slurm and Grid Engine, whose daemons are started on this machine for the test, which needs root.
"""
import argparse, json, os, pathlib, shutil, signal, socket, subprocess, sys, tempfile, time

COUNT = 8
SIZE = "1280x720"
SCENE = """#version 3.7;
global_settings { assumed_gamma 1 photons { spacing 0.05 } radiosity { count 30 error_bound 1 } }
camera { location <0, 3, -6> right x * image_width / image_height look_at <0, 0.7, 0> }
light_source { <-4, 6, 1> rgb 1 area_light x, z, 3, 3 jitter }
plane { y, 0 pigment { checker rgb 0.9, rgb <0.3, 0.5, 0.7> } }
sphere { <0, 0.8, 0>, 0.7 pigment { rgbf 1 } interior { ior 1.5 } photons { target refraction on } }
#for (I, 0, 20) sphere { <2 * sin(I), 0.2, 2 * cos(I)>, 0.2 pigment { granite } } #end
"""


def wait_for(is_done, seconds, what):
    end = time.time() + seconds
    while not is_done():
        if time.time() > end:
            raise SystemExit(f"{what}: not after {seconds} s")
        time.sleep(0.2)


def check(call, **words):
    return subprocess.run(call, check=True, capture_output=True, text=True, **words).stdout


class Farm:
    def __init__(self, durer, folder):
        self.durer, self.folder = durer, folder
        (folder / "big.pov").write_text(SCENE)
        self.line = [durer, "render", "big.pov", "--size", SIZE, "-j1"]
        check([*self.line, "-o", "whole.png"], cwd=folder)

    def merged_is_whole(self, name):
        check([self.durer, "merge", f"{name}.png"], cwd=self.folder)
        if (self.folder / f"{name}.png").read_bytes() != (self.folder / "whole.png").read_bytes():
            raise SystemExit(f"{name}: the merged picture has other bytes")

    def kill_one(self, name, shard):
        """Starts a shard, and kills it while it renders, or leaves it finished if it was too quick."""
        process = subprocess.Popen([*self.line, "-o", f"{name}.png", "--shard", f"{shard}/{COUNT}", "--keep-after", "0"],
                                   cwd=self.folder, stderr=subprocess.DEVNULL)
        journal = self.folder / f"{name}.png.shard-{shard}-of-{COUNT}.unfinished"
        while process.poll() is None and not (journal.exists() and journal.stat().st_size > 0):
            time.sleep(0.01)
        process.send_signal(signal.SIGTERM)
        return process.wait()


def parallel(farm):
    if not shutil.which("parallel"):
        return "GNU parallel is not installed"
    code = farm.kill_one("gnu", 3)
    shards = [*range(1, COUNT + 1), 5]
    call = ["parallel", "--will-cite", "-j2", "--joblog", "gnu.log", "--resume-failed",
            *farm.line, "-o", "gnu.png", "--shard", f"{{}}/{COUNT}", ":::", *map(str, shards)]
    check(call, cwd=farm.folder)
    farm.merged_is_whole("gnu")
    return f"ok: GNU parallel (one task was killed and ended with {code})"


def openjd(farm):
    places = [shutil.which("openjd"), pathlib.Path(sys.executable).parent / "openjd", "/tmp/durer-clients-venv/bin/openjd"]
    program = next((str(place) for place in places if place and os.path.exists(place)), None)
    if not program:
        return "openjd-cli is not installed"
    code = farm.kill_one("openjd", 3)
    twice = subprocess.Popen([*farm.line, "-o", "openjd.png", "--shard", f"8/{COUNT}"], cwd=farm.folder, stderr=subprocess.DEVNULL)
    command = " ".join([*farm.line, "-o", "openjd.png", "--progress", "openjd", "--shard", f"{{{{Task.Param.Shard}}}}/{COUNT}"])
    template = {
        "specificationVersion": "jobtemplate-2023-09",
        "name": "durer",
        "steps": [{
            "name": "render",
            "parameterSpace": {"taskParameterDefinitions": [{"name": "Shard", "type": "INT", "range": f"1-{COUNT}"}]},
            "script": {"actions": {"onRun": {"command": "sh", "args": ["-c", f"cd {farm.folder} && {command}"]}}},
        }],
    }
    path = farm.folder / "job.template.json"
    path.write_text(json.dumps(template))
    out = check([program, "run", str(path), "--step", "render"], cwd=farm.folder)
    if "openjd_progress: 100.0" not in out:
        raise SystemExit(f"openjd: no progress in\n{out}")
    twice.wait()
    farm.merged_is_whole("openjd")
    return f"ok: Open Job Description (one task was killed and ended with {code})"


HYPERQUEUE = """
import sys
from hyperqueue import Job
from hyperqueue.cluster import LocalCluster, WorkerConfig
folder, line = sys.argv[1], sys.argv[2:]
with LocalCluster() as cluster:
    cluster.start_worker(WorkerConfig(cores=2))
    client = cluster.client()
    job = Job(default_workdir=folder, max_fails=0)
    # The Python interface counts tasks from 0, `hq submit --array 1-8` from 1.
    job.program(["true"])
    for _ in range(COUNT):
        job.program(line)
    client.wait_for_jobs([client.submit(job)])
"""


def hyperqueue(farm):
    pythons = [sys.executable, "/tmp/durer-clients-venv/bin/python"]
    has_it = lambda python: os.path.exists(python) and subprocess.run([python, "-c", "import hyperqueue"], capture_output=True).returncode == 0
    python = next(filter(has_it, pythons), None)
    if not python:
        return "hyperqueue is not installed"
    code = farm.kill_one("hq", 2)
    call = [*farm.line, "-o", "hq.png", "--shard", f"auto/{COUNT}"]
    twice = subprocess.Popen([*farm.line, "-o", "hq.png", "--shard", f"8/{COUNT}"], cwd=farm.folder, stderr=subprocess.DEVNULL)
    subprocess.run([python, "-c", HYPERQUEUE.replace("COUNT", str(COUNT)), str(farm.folder), *call], cwd=farm.folder,
                   capture_output=True, timeout=300)
    twice.wait()
    # The task that found its shard in use ended with exit code 5, and is run again.
    check([*farm.line, "-o", "hq.png", "--shard", f"8/{COUNT}"], cwd=farm.folder)
    farm.merged_is_whole("hq")
    return f"ok: HyperQueue (one task was killed and ended with {code})"


# Makes the editor of `qconf -aq` fill in the queue that it shows.
QUEUE_EDITOR = """#!/bin/sh
sed -i -e 's/^pe_list .*/pe_list NONE/' -e 's/^hostlist .*/hostlist localhost/' -e 's/^slots .*/slots 2/' \\
    -e 's/^load_thresholds .*/load_thresholds NONE/' -e 's|^shell .*|shell /bin/sh|' "$1"
"""
# Exit code 99 asks Grid Engine to run the task again.
GRID_ENGINE_JOB = """#!/bin/sh
{line}
code=$?
[ $code = 75 ] && exit 99
exit $code
"""


def grid_engine(farm):
    system = pathlib.Path("/var/lib/gridengine")
    if not all(map(shutil.which, ("sge_qmaster", "sge_execd", "qsub"))) or os.geteuid() != 0 or not system.exists():
        return "Grid Engine is not installed, or the test does not run as root"
    root, spool = farm.folder / "sge", farm.folder / "sge-spool"
    shutil.copytree(system, root, symlinks=True)
    common = root / "default/common"
    common.mkdir(parents=True, exist_ok=True)
    for part in ("qmaster/job_scripts", "db"):
        (spool / part).mkdir(parents=True)
    bootstrap = pathlib.Path("/usr/share/gridengine/default-bootstrap").read_text()
    bootstrap = bootstrap.replace("/var/spool/gridengine/spooldb", f"{spool}/db").replace("/var/spool/gridengine/qmaster", f"{spool}/qmaster")
    (common / "bootstrap").write_text(bootstrap)
    (common / "act_qmaster").write_text("localhost\n")
    (common / "host_aliases").write_text(f"localhost {socket.gethostname()}\n")
    check(["chown", "-R", "sgeadmin", str(root), str(spool)])
    editor = farm.folder / "queue-editor"
    editor.write_text(QUEUE_EDITOR)
    editor.chmod(0o755)
    farm.folder.chmod(0o777)
    environment = {**os.environ, "SGE_ROOT": str(root), "SGE_CELL": "default", "SGE_ND": "1", "EDITOR": str(editor),
                   "SGE_QMASTER_PORT": "16444", "SGE_EXECD_PORT": "16445"}
    as_user = lambda user, *words: check(["runuser", "-u", user, "--", *words], cwd=farm.folder, env=environment)
    as_user("sgeadmin", "/usr/share/gridengine/scripts/init_cluster", str(root), "default", f"{spool}/db", "sgeadmin")
    daemons = []
    start = lambda program: daemons.append(
        subprocess.Popen([shutil.which(program)], env=environment, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL))
    answers = lambda: subprocess.run(["qconf", "-sh"], env=environment, capture_output=True).returncode == 0
    try:
        start("sge_qmaster")
        wait_for(answers, 60, "grid engine: the master answers")
        subprocess.run(["runuser", "-u", "sgeadmin", "--", "qconf", "-ah", "localhost"], env=environment, capture_output=True)
        as_user("sgeadmin", "qconf", "-as", "localhost")
        start("sge_execd")
        wait_for(lambda: "localhost" in subprocess.run(["qconf", "-sel"], env=environment, capture_output=True, text=True).stdout,
                 60, "grid engine: the host is known")
        as_user("sgeadmin", "qconf", "-aq", "all.q")
        line = " ".join([*farm.line, "-o", "sge.png", "--shard", "auto", "--keep-after", "0"])
        script = farm.folder / "sge-job.sh"
        script.write_text(GRID_ENGINE_JOB.format(line=line))
        as_user("nobody", "qsub", "-cwd", "-r", "y", "-t", f"1-{COUNT}", str(script))
        # One task is terminated and run again; one is started twice.
        journals = lambda: [path for path in farm.folder.glob("sge.png.shard-*.unfinished") if path.stat().st_size > 0]
        wait_for(journals, 120, "grid engine: a task runs")
        subprocess.run(["pkill", "-TERM", "-o", "-f", "sge.png --shard auto"], capture_output=True)
        subprocess.run([*farm.line, "-o", "sge.png", "--shard", f"4/{COUNT}"], cwd=farm.folder, capture_output=True)
        is_done = lambda: not check(["qstat", "-u", "*"], env=environment).strip()
        wait_for(is_done, 300, "grid engine: all tasks have ended")
        # The task that found its shard in use, if any, is run again.
        check([*farm.line, "-o", "sge.png", "--shard", f"4/{COUNT}"], cwd=farm.folder)
        farm.merged_is_whole("sge")
        return "ok: Grid Engine (one task was terminated and run again)"
    finally:
        for daemon in reversed(daemons):
            daemon.terminate()
        for daemon in daemons:
            daemon.wait()


SLURM = """ClusterName=test
SlurmctldHost={host}
AuthType=auth/munge
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
SlurmUser=root
SlurmdUser=root
StateSaveLocation={folder}/state
SlurmdSpoolDir={folder}/spool
SlurmctldPidFile={folder}/slurmctld.pid
SlurmdPidFile={folder}/slurmd.pid
SlurmctldLogFile={folder}/slurmctld.log
SlurmdLogFile={folder}/slurmd.log
JobRequeue=1
ReturnToService=2
NodeName={host} CPUs={cpus} State=UNKNOWN
PartitionName=all Nodes=ALL Default=YES MaxTime=INFINITE State=UP
"""


def slurm(farm):
    if not all(map(shutil.which, ("slurmctld", "slurmd", "sbatch", "munged"))) or os.geteuid() != 0:
        return "Slurm is not installed, or the test does not run as root"
    folder = farm.folder / "slurm"
    for part in ("state", "spool"):
        (folder / part).mkdir(parents=True)
    conf = folder / "slurm.conf"
    conf.write_text(SLURM.format(host=socket.gethostname().split(".")[0], folder=folder, cpus=os.cpu_count()))
    environment = {**os.environ, "SLURM_CONF": str(conf)}
    os.makedirs("/run/munge", exist_ok=True)
    shutil.chown("/run/munge", "munge", "munge")
    subprocess.run(["runuser", "-u", "munge", "--", "munged", "--force"], check=False, capture_output=True)
    daemons = [subprocess.Popen([program, "-D", *words, "-f", str(conf)], env=environment,
                                stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
               for program, words in (("slurmctld", ["-c"]), ("slurmd", []))]
    call = lambda *words: check(words, cwd=farm.folder, env=environment)
    try:
        def is_up():
            state = subprocess.run(["sinfo", "-h", "-o", "%T"], env=environment, capture_output=True, text=True)
            return state.stdout.strip() == "idle"
        wait_for(is_up, 60, "slurm: the node is up")
        script = folder / "job.sh"
        line = " ".join([*farm.line, "-o", "slurm.png", "--shard", "auto", "--keep-after", "0"])
        script.write_text(f"#!/bin/sh\n#SBATCH --requeue\nexec {line}\n")
        job = call("sbatch", "--parsable", f"--array=0-{COUNT - 1}", str(script)).strip()
        # One task is killed and requeued; one is started twice.
        started = lambda: any(farm.folder.glob("slurm.png.shard-*"))
        wait_for(started, 60, "slurm: a task runs")
        subprocess.run(["scontrol", "requeue", f"{job}_1"], env=environment, capture_output=True)
        subprocess.run([*farm.line, "-o", "slurm.png", "--shard", f"4/{COUNT}"], cwd=farm.folder, capture_output=True)
        wait_for(lambda: not call("squeue", "-h").strip(), 300, "slurm: all tasks have ended")
        farm.merged_is_whole("slurm")
        return "ok: Slurm"
    finally:
        for daemon in daemons:
            daemon.terminate()
        for daemon in daemons:
            daemon.wait()
        subprocess.run(["munged", "--stop"], capture_output=True)


SCHEDULERS = (parallel, openjd, hyperqueue, slurm, grid_engine)


def main():
    options = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_argument("--durer", required=True)
    options.add_argument("--only", choices=[scheduler.__name__ for scheduler in SCHEDULERS])
    options = options.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        farm = Farm(os.path.abspath(options.durer), pathlib.Path(folder))
        for scheduler in SCHEDULERS:
            if options.only in (None, scheduler.__name__):
                result = scheduler(farm)
                print(result if result.startswith("ok") else f"skipped: {result}", flush=True)


if __name__ == "__main__":
    sys.exit(main())
