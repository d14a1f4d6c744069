# SPDX-License-Identifier: GPL-3.0-or-later
"""Circles among units (a header with the .cpp of its name) and among folders, by what they include."""
import collections
import re

FOLDERS = ("devices/", "widgets/", "app/")

# Circles that are still there, each as the set of its members; they may shrink, and what is gone goes from here.
KNOWN_UNITS = []
KNOWN_FOLDERS = []


def includes(path, text, paths):
    for match in re.finditer(r'(?m)^[ \t]*#[ \t]*include[ \t]*"([^"]+)"', text):
        for target in (match[1], f"devices/{match[1]}"):
            if target in paths:
                yield target


def graph_of(files, node):
    """files: {path: text}; node: path -> name of its node."""
    graph = collections.defaultdict(set)
    for path, text in files.items():
        for target in includes(path, text, files):
            if node(target) != node(path):
                graph[node(path)].add(node(target))
    return graph


def circles(graph):
    """Strongly connected parts of more than one node (Tarjan), each as a sorted list."""
    order, lowest, stack, found = {}, {}, [], []

    def visit(start):
        todo = [(start, iter(sorted(graph[start])))]
        order[start] = lowest[start] = len(order)
        stack.append(start)
        while todo:
            at, rest = todo[-1]
            following = next(rest, None)
            if following is None:
                todo.pop()
                if todo:
                    lowest[todo[-1][0]] = min(lowest[todo[-1][0]], lowest[at])
                if lowest[at] == order[at]:
                    part = stack[stack.index(at):]
                    del stack[stack.index(at):]
                    if len(part) > 1:
                        found.append(sorted(part))
            elif following not in order:
                order[following] = lowest[following] = len(order)
                stack.append(following)
                todo.append((following, iter(sorted(graph[following]))))
            elif following in stack:
                lowest[at] = min(lowest[at], order[following])

    for start in sorted(graph):
        if start not in order:
            visit(start)
    return sorted(found)


def folder_of(path):
    """Backends are a part of the library that chooses among them."""
    return path.rsplit("/", 1)[0].removesuffix("/backends")


def check(files):
    """Yields what is wrong, a line for each; `files` are the sources of FOLDERS by their path."""
    files = {path: text for path, text in files.items() if path.startswith(FOLDERS)}
    for what, node, known in (("units", lambda path: path.rsplit(".", 1)[0], KNOWN_UNITS), ("folders", folder_of, KNOWN_FOLDERS)):
        found = [set(circle) for circle in circles(graph_of(files, node))]
        for circle in found:
            if not any(circle <= old for old in known):
                yield f"circle of {what}: {', '.join(sorted(circle))}"
