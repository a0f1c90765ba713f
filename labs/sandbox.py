"""Runs a stranger's program where it can harm nobody: by bubblewrap, or where that does not work by limits alone."""

import ctypes
import os
from pathlib import Path
import shutil
import signal
import subprocess
import time

PR_SET_CHILD_SUBREAPER = 36  # <linux/prctl.h>
FIRST_USER = 1879048192  # systemd's list of numbers of users: nobody has one from here on
MEGABYTE = 1 << 20
VIEW = ["--ro-bind", "/usr", "/usr", "--symlink", "usr/bin", "/bin", "--symlink", "usr/lib", "/lib", "--symlink", "usr/lib64", "/lib64",
        "--perms", "0755", "--dir", "/etc", "--ro-bind-try", "/etc/alternatives", "/etc/alternatives", "--proc", "/proc", "--dev", "/dev",
        "--size", str(64 * MEGABYTE), "--perms", "1777", "--tmpfs", "/tmp"]


def can_change_user():
    """Whether we may become a user whom nobody else is: the limit of processes does not hold for root."""
    mapped = [line.split() for line in Path("/proc/self/uid_map").read_text(encoding="ascii").splitlines()]
    return os.geteuid() == 0 and any(int(first) + int(count) > FIRST_USER + (1 << 22) for first, _, count in mapped)


def processes_of_user():
    """How many threads this user has, for so the kernel counts."""
    count = 0
    for process in Path("/proc").glob("[0-9]*"):
        try:
            count += len(os.listdir(process / "task")) if process.stat().st_uid == os.getuid() else 0
        except OSError:  # it has ended
            pass
    return count


class Sandbox:
    """Of one answer: it sees its own folder, /usr and a small /tmp. Processes and files end with it.

    `folder` is where it works; `hidden` are folders that it must not see, such as that of the solutions."""

    def __init__(self, folder, has_bwrap, memory, seconds, hidden=()):
        self.folder, self.has_bwrap, self.memory, self.seconds = folder, has_bwrap, memory, seconds
        self.hidden = [str(one) for one in hidden if one.is_relative_to("/usr")]
        self.user = FIRST_USER + os.getpid() if can_change_user() else None
        if self.user:
            os.chown(folder, self.user, self.user)

    def limits(self, processes):
        if not self.has_bwrap and not self.user:
            processes += processes_of_user()
        return ["prlimit", f"--nproc={processes}", f"--as={self.memory * MEGABYTE}", f"--fsize={64 * MEGABYTE}", "--core=0",
                "--nofile=256", f"--cpu={self.seconds + 1}", "--"]

    def command(self, words, is_writable=False, processes=8):
        """The words that run `words` inside, in `folder`; only where it is writable may it be changed."""
        user = ["setpriv", f"--reuid={self.user}", f"--regid={self.user}", "--clear-groups", "--no-new-privs", "--"] if self.user else []
        limited = [*user, *self.limits(processes), *words]
        if not self.has_bwrap:
            return ["env", "-i", "PATH=/usr/bin:/bin", "LANG=C.UTF-8", "TMPDIR=.", "HOME=/nonexistent", *limited]
        root = ["--cap-add", "CAP_SETUID", "--cap-add", "CAP_SETGID"] if self.user else []
        return ["bwrap", *([] if self.user else ["--unshare-user"]), "--unshare-ipc", "--unshare-pid", "--unshare-net", "--unshare-uts",
                "--unshare-cgroup-try", "--die-with-parent", "--cap-drop", "ALL", *root, *VIEW,
                *sum((["--tmpfs", one] for one in self.hidden), []),
                "--bind" if is_writable else "--ro-bind", str(self.folder), "/answer", "--remount-ro", "/dev", "--remount-ro", "/",
                "--chdir", "/answer", "--clearenv", "--setenv", "PATH", "/usr/bin:/bin", "--setenv", "LANG", "C.UTF-8", *limited]

    def trouble(self, words):
        """What stands in the way of running `words`; empty where nothing does."""
        try:
            ended = subprocess.run(self.command(words), cwd=self.folder, capture_output=True, text=True, timeout=60, check=False)
        except (OSError, subprocess.TimeoutExpired) as problem:
            return str(problem)
        return (ended.stderr.strip() or f"exit status {ended.returncode}").splitlines()[0] if ended.returncode else ""


def choose(folder, options):
    """Whether to use bubblewrap, and a sentence for the teacher."""
    if options.sandbox == "prlimit":
        why = "it was not wanted"
    elif not shutil.which("bwrap"):
        why = "it is not installed"
    else:
        why = Sandbox(folder, True, options.memory, options.seconds).trouble(["true"])
    if not why:
        return True, "bubblewrap: each answer has no network, and files and processes of its own"
    processes = "" if os.geteuid() or can_change_user() else ", root's processes are not limited in number"
    return False, f"limits by prlimit alone, without bubblewrap ({why}): the network and other folders are open to an answer{processes}"


def adopt_orphans():
    """Whatever our children start and leave behind becomes our child, so that `end_all` finds it."""
    if ctypes.CDLL(None, use_errno=True).prctl(PR_SET_CHILD_SUBREAPER, 1, 0, 0, 0):
        raise OSError(ctypes.get_errno(), "orphans cannot be adopted")


def descendants():
    """The processes below this one."""
    parents = {}
    for stat in Path("/proc").glob("[0-9]*/stat"):
        try:
            parents[int(stat.parent.name)] = int(stat.read_text(encoding="utf-8", errors="replace").rpartition(")")[2].split()[1])
        except OSError:  # it has ended
            pass
    found = {os.getpid()}
    while more := {child for child, parent in parents.items() if parent in found} - found:
        found |= more
    return found - {os.getpid()}


def end_all(seconds=10):
    """Ends every process below this one; one that goes on forking is stopped first. Whether none is left."""
    end = time.monotonic() + seconds
    while time.monotonic() < end:
        for number in (signal.SIGSTOP, signal.SIGKILL):
            for process in descendants():
                try:
                    os.kill(process, number)
                except ProcessLookupError:
                    pass
        try:
            while os.waitpid(-1, os.WNOHANG) != (0, 0):
                pass
        except ChildProcessError:
            return True
        time.sleep(0.01)
    return False
