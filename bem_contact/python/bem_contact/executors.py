"""Work shared by an executor: of concurrent.futures, mpi4py.futures, Dask (client.get_executor()), loky.

A task is a function of this package and its arguments, all of which can be pickled. It may run in any process that can import
bem_contact and sees the same files, and says the same wherever it runs.
"""

import concurrent.futures
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


def run_each(executor, kind, tasks, take):
    """take(number of the task, its result) for each task of a kind, as soon as it is there. No result is kept."""
    if executor is None:
        for number, task in enumerate(tasks):
            take(number, part(kind, *task))
        return
    numbers = {executor.submit(part, kind, *task): number for number, task in enumerate(tasks)}
    try:
        # Somebody else's futures are waited for in their order.
        known = all(isinstance(future, concurrent.futures.Future) for future in numbers)
        for future in concurrent.futures.as_completed(list(numbers)) if known else list(numbers):
            take(numbers.pop(future), future.result())
            del future
    except BaseException:
        for future in numbers:
            future.cancel()
        raise
