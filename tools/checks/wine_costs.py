"""What a command costs under wine, with all processes that wine starts beside it and leaves behind. It is a module of try_windows, and runs itself."""

import ctypes
import json
import os
import subprocess
import sys
import time

SUBREAPER = 36  # of prctl(): whoever loses its parent below this process becomes its child


def cost(words, **options):
    """{"code", "seconds": until the command ends, "own": seconds of the processor of its process alone, "all": of all processes, also of wine's
    server, for whose end it waits}. `options`: of subprocess.run(). What the command prints is dropped."""
    done = subprocess.run([sys.executable, __file__, *map(str, words)], stdout=subprocess.PIPE, check=True, **options)
    return json.loads(done.stdout)


def main(words):
    ctypes.CDLL(None).prctl(SUBREAPER, 1, 0, 0, 0)
    began = time.monotonic()
    command = subprocess.Popen(words, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL).pid
    out = {"all": 0.0}
    while True:
        try:
            process, status, used = os.wait4(-1, 0)
        except ChildProcessError:
            break
        seconds = used.ru_utime + used.ru_stime  # with the children for which it has waited
        out["all"] += seconds
        if process == command:
            out.update(code=os.waitstatus_to_exitcode(status), seconds=time.monotonic() - began, own=seconds)
    print(json.dumps(out))


if __name__ == "__main__":
    main(sys.argv[1:])
