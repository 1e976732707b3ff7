# SPDX-License-Identifier: MIT
"""A Slurm of one node that belongs to a test: own munge, own controller, own node, all files in one folder."""

import os
import pathlib
import secrets
import shutil
import socket
import subprocess

from sweep_tables import wait_for

PROGRAMS = {"munged": "munge", "slurmctld": "slurmctld", "slurmd": "slurmd", "sbatch": "slurm-client"}


def found(program):
    return shutil.which(program, path=os.environ.get("PATH", "") + ":/usr/sbin:/usr/bin")


def missing_packages():
    return sorted({package for program, package in PROGRAMS.items() if not found(program)})


def free_port():
    with socket.socket() as one:
        one.bind(("127.0.0.1", 0))
        return one.getsockname()[1]


def configuration(place, cores):
    name = socket.gethostname().split(".")[0]
    user = subprocess.run(["id", "-un"], capture_output=True, text=True, check=True).stdout.strip()
    return f"""ClusterName=camopt
SlurmctldHost={name}(127.0.0.1)
SlurmctldPort={free_port()}
SlurmdPort={free_port()}
SlurmUser={user}
SlurmdUser={user}
AuthType=auth/munge
AuthInfo=socket={place}/munge/socket
CredType=cred/munge
StateSaveLocation={place}/state
SlurmdSpoolDir={place}/spool
SlurmctldPidFile={place}/slurmctld.pid
SlurmdPidFile={place}/slurmd.pid
SlurmctldLogFile={place}/slurmctld.log
SlurmdLogFile={place}/slurmd.log
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
MpiDefault=none
SwitchType=switch/none
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
SchedulerType=sched/builtin
SchedulerParameters=batch_sched_delay=0,sched_interval=1,sched_min_interval=0
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
KillWait=5
ReturnToService=2
NodeName={name} NodeAddr=127.0.0.1 CPUs={cores} Boards=1 SocketsPerBoard=1 CoresPerSocket={cores} ThreadsPerCore=1 State=UNKNOWN
PartitionName=all Nodes={name} Default=YES MaxTime=INFINITE State=UP
"""


class PrivateSlurm:
    """Runs from entering to leaving; `environment` is that of its commands."""

    def __init__(self, place):
        self.place = pathlib.Path(place)
        self.environment = dict(os.environ, SLURM_CONF=str(self.place / "slurm.conf"),
                                PATH=os.environ.get("PATH", "") + ":/usr/sbin:/usr/bin")
        self.daemons = []

    def __enter__(self):
        try:
            self.start_munge()
            for folder in ("state", "spool"):
                (self.place / folder).mkdir()
            (self.place / "slurm.conf").write_text(configuration(self.place, max(2, os.cpu_count() or 1)))
            self.start("slurmctld", "-D")
            self.start("slurmd", "-D", "-N", socket.gethostname().split(".")[0])
            if not wait_for(lambda: self.said("sinfo", "-h", "-o", "%T") == "idle", 60):
                raise RuntimeError("the node never became idle\n" + self.logs())
        except BaseException:
            self.__exit__()
            raise
        return self

    def __exit__(self, *_):
        for daemon in reversed(self.daemons):
            daemon.terminate()
            try:
                daemon.wait(20)
            except subprocess.TimeoutExpired:
                daemon.kill()
                daemon.wait()

    def start_munge(self):
        """Its key and socket must lie where no other user could have put them."""
        munge = self.place / "munge"
        munge.mkdir()
        munge.chmod(0o711)
        key = munge / "key"
        key.write_bytes(secrets.token_bytes(128))
        key.chmod(0o400)
        self.start("munged", "--foreground", "--force", f"--socket={munge}/socket", f"--key-file={key}",
                   f"--pid-file={munge}/pid", f"--seed-file={munge}/seed", f"--log-file={munge}/log")
        if not wait_for((munge / "socket").exists, 20):
            raise RuntimeError("munged made no socket\n" + self.logs())

    def start(self, program, *words):
        log = open(self.place / f"{program}.out", "w", encoding="utf-8")  # pylint: disable=consider-using-with
        self.daemons.append(subprocess.Popen([found(program), *words], env=self.environment, stdout=log, stderr=log))
        log.close()

    def run(self, *command, folder=None):
        return subprocess.run(command, env=self.environment, cwd=folder, capture_output=True, text=True, timeout=120,
                              check=False)

    def said(self, *command):
        return self.run(*command).stdout.strip()

    def submit(self, folder, *words):
        """The number of the job."""
        done = self.run("sbatch", "--parsable", *words, folder=folder)
        if done.returncode != 0:
            raise RuntimeError(done.stderr + self.logs())
        return done.stdout.strip()

    def wait_for_job(self, job, seconds=240):
        if not wait_for(lambda: not self.said("squeue", "-h", "-j", job, "-o", "%T"), seconds):
            raise RuntimeError(f"job {job} does not end\n" + self.logs())

    def logs(self):
        return "\n".join(f"== {path}\n{path.read_text(errors='replace')[-2000:]}"
                         for path in sorted(self.place.glob("*.out")) + sorted(self.place.glob("*.log")))
