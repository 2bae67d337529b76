"""Work shared by an executor: of concurrent.futures, mpi4py.futures, Dask (client.get_executor()), loky.

A task is a function of this package and its arguments, all of which can be pickled. It may run in any process that can import
bem_contact and sees the same files, and says the same wherever it runs.
"""

from importlib import import_module


def part(kind, *arguments):
    """One task, in the process or thread that the executor has chosen."""
    return getattr(import_module("bem_contact._core"), f"_{kind}_part")(*arguments)


def results_of(executor, function, tasks):
    """What the function gives for the arguments of each task, in their order. Where one raises, those that have not begun are given up."""
    futures = [executor.submit(function, *task) for task in tasks]
    try:
        return [future.result() for future in futures]
    except BaseException:
        for future in futures:
            future.cancel()
        raise


def run_on(executor, kind, tasks):
    """The results of all tasks of a kind."""
    return results_of(executor, part, [(kind, *task) for task in tasks])
