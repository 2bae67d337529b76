"""Work shared by an executor: of concurrent.futures, mpi4py.futures, Dask (client.get_executor()), loky.

A task is a name, what all portions of some work have in common, and one portion, as bytes. It may run in any process that can import
bem_contact and sees the same files, and says the same wherever it runs.
"""

import concurrent.futures
from importlib import import_module


def answer(task, common, portion):
    """That of one portion, in the process or thread that the executor has chosen."""
    return import_module("bem_contact._core")._run_task(task, common, portion)


def results_of(executor, function, tasks):
    """What the function gives for the arguments of each task, in their order. Where one raises, those that have not begun are given up."""
    futures = [executor.submit(function, *task) for task in tasks]
    try:
        return [future.result() for future in futures]
    except BaseException:
        for future in futures:
            future.cancel()
        raise


def run_each(executor, task, common, portions, take):
    """take(number of the portion, its answer) for each, as soon as it is there. No answer is kept. No executor: here."""
    if executor is None:
        for number, portion in enumerate(portions):
            take(number, answer(task, common, portion))
        return
    numbers = {executor.submit(answer, task, common, portion): number for number, portion in enumerate(portions)}
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
