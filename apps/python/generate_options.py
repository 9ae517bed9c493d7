#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
# Part of PclSurfaceRepair: the options of the Python functions, from the C++ headers.
"""Write what the bindings and the Python package know of options.

An option is a member of a public options struct, or a setter of a class that has none; its name,
type, default and description come from the header. A member is known by its own name, behind that
of the member that holds it where two options of a function would be called alike. Its description
has a sentence "Set it ...", which tells when one needs the option.

usage: generate_options.py INCLUDE_FOLDER... --cpp FILE --python FILE
"""
import argparse
import re
import sys
from pathlib import Path

# Of each Python function: the C++ variable, and the class or struct that it is.
FUNCTIONS = {
    "clean": [("parameters", "app::CleanParameters")],
    "reconstruct": [("start", "pcl::ccaa::GreedyParameters"), ("filter", "pcl::UmbrellaFilter"),
                    ("base", "pcl::ccaa::CompletionParameters")],
    "umbrella_filter": [("filter", "pcl::UmbrellaFilter")],
    "classify_boundaries": [("classifier", "pcl::BoundaryClassifier")],
    "repair": [("method", "pcl::repair::RepairParameters")],
}
# Arguments of the functions instead of options; a search method is an algorithm, not a value.
ARGUMENTS = {"ccaa::SideHints", "PointSearchPtr", "std::shared_ptr<const Decisions>",
             "pcl::PolygonMesh::ConstPtr"}
PYTHON_TYPES = {"bool": "bool", "double": "float", "unsigned int": "int", "std::size_t": "int",
                "Extent": "float | str"}
DOC = r"(?:/\*\*(?!<)(?P<before>(?:[^*]|\*(?!/))*)\*/\s*)?"
MEMBER = re.compile(DOC + r"(?P<type>[\w:]+(?:<[\w: ]+>)?(?: int)?) (?P<name>\w+)"
                    r"(?: *= *(?P<value>[^;]*))?;(?:\s*/\*\*<(?P<after>(?:[^*]|\*(?!/))*)\*/)?")
SETTER = re.compile(DOC + r"void\s+set(?P<name>\w+)\((?P<type>[\w:]+(?: int)?) \w+\)")
INHERITED = re.compile(r"[Ii]ts (\w+) is that of the \w+")


def plain(text):
    """A Doxygen comment as one line of text."""
    text = re.sub(r"\\brief|^\s*\*", "", text or "", flags=re.M)
    return " ".join(text.split())


def body_of(kind, name, headers):
    """What stands between the braces of a type; None where it is none of ours."""
    found = re.search(rf"\b{kind} {name}\b[^;{{]*{{(.*?)^}};", headers, re.S | re.M)
    return found and found[1]


def words_of(enum, headers):
    """The enumerators of an enum class; None where it is none of ours."""
    body = re.search(rf"enum class {enum}\b[^{{]*{{(.*?)}}", headers, re.S)
    return body and re.findall(r"\b[A-Z][A-Z_0-9]+\b",
                               re.sub(r"/\*.*?\*/", "", body[1], flags=re.S))


def about_enum(enum, headers):
    found = re.search(rf"/\*\*((?:[^*]|\*(?!/))*)\*/\s*enum class {enum}\b", headers)
    return plain(found and found[1])


def members(struct, headers):
    """(type, name, description) of each member, in order; all code has to be understood."""
    body = body_of("struct", struct, headers) or sys.exit(
        f"generate_options.py: '{struct}' is neither a known type nor a struct")
    functions = r"(?:/\*\*(?!<)(?:[^*]|\*(?!/))*\*/\s*)?^  \w+(?:\n  \w+)?\([^;]*?{.*?^  }\n"
    body = re.sub(functions, "", body, flags=re.S | re.M)
    rest = re.sub(r"/\*.*?\*/|\s", "", MEMBER.sub("", body), flags=re.S)
    if rest:
        sys.exit(f"generate_options.py: struct {struct}: not understood: {rest}")
    return [(found["type"], found["name"], plain(found["before"]) or plain(found["after"]))
            for found in MEMBER.finditer(body)]


def leaves(kind, path, headers):
    """(path, type, description, is a setter) of all options below a variable."""
    setters = body_of("class", kind, headers)
    if setters:
        for found in SETTER.finditer(setters):
            snake = re.sub(r"(?<!^)(?=[A-Z])", "_", found["name"]).lower()
            yield path + [snake], found["type"], plain(found["before"]), found["name"]
        return
    for member_type, name, about in members(kind, headers):
        if member_type in ARGUMENTS:
            continue
        if member_type in PYTHON_TYPES or words_of(member_type, headers):
            yield path + [name], member_type, about or about_enum(member_type, headers), None
        else:
            inherited = INHERITED.findall(about)
            for leaf in leaves(member_type, path + [name], headers):
                if leaf[0][-1] not in inherited:
                    yield leaf


def options_of(function, headers):
    """(Python name, path, type, description, setter) of all options of a function."""
    found = [leaf for variable, kind in FUNCTIONS[function]
             for leaf in leaves(kind.split("::")[-1], [variable], headers)]
    last = [leaf[0][-1] for leaf in found]
    for path, kind, about, setter in found:
        name = path[-1]
        if name == "choice":  # of what, its struct tells
            name = path[-2]
        elif last.count(name) > 1 or "dropped" in path:
            name = "_".join(path[-2:])
        yield name, path, kind, about, setter


def camel(function):
    return function.title().replace("_", "")


def cpp(functions, headers):
    enums = sorted({option[2] for options in functions.values() for option in options
                    if option[2] not in PYTHON_TYPES})
    yield "// Made by apps/python/generate_options.py from the headers; not to be edited."
    yield "#pragma once\n"
    for enum in enums:
        words = ", ".join(f'{{"{word.lower()}", pcl::repair::{enum}::{word}}}'
                          for word in words_of(enum, headers))
        yield (f"inline std::vector<std::pair<const char*, pcl::repair::{enum}>>\n"
               f"wordsOf(pcl::repair::{enum})\n{{\n  return {{{words}}};\n}}\n")
    for function, options in functions.items():
        variables = ", ".join(f"{kind}& {variable}" for variable, kind in FUNCTIONS[function])
        yield (f"template <typename Visit>\nvoid\n"
               f"visit{camel(function)}Options({variables}, const Visit& visit)\n{{")
        for name, path, _, _, setter in options:
            if setter is None:
                yield f'  visit("{name}", {".".join(path)});'
            else:
                yield (f"  {{\n    auto value = {path[0]}.get{setter}();\n"
                       f'    visit("{name}", value);\n    {path[0]}.set{setter}(value);\n  }}')
        yield "}\n"


def python(functions, headers):
    yield '"""Options of the functions, made from the C++ headers; not to be edited."""'
    yield "from __future__ import annotations\n\nfrom typing import Literal, TypedDict\n"
    for function, options in functions.items():
        yield f"\nclass {camel(function)}Options(TypedDict, total=False):"
        for name, _, kind, _, _ in options:
            literal = ", ".join(f'"{word.lower()}"' for word in words_of(kind, headers) or [])
            yield f"    {name}: {PYTHON_TYPES.get(kind) or f'Literal[{literal}]'}"
    yield "\n\nABOUT = {"
    for function, options in functions.items():
        yield f"    {function!r}: {{"
        yield from (f"        {option[0]!r}: {option[3]!r}," for option in options)
        yield "    },"
    yield "}"


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("include", nargs="+", type=Path)
    parser.add_argument("--cpp", type=Path, required=True)
    parser.add_argument("--python", type=Path, required=True)
    arguments = parser.parse_args()
    headers = "\n".join(header.read_text(encoding="utf-8") for folder in arguments.include
                        for header in sorted(folder.glob("*.h")))
    headers = re.sub(r"//.*", "", headers)
    functions = {function: list(options_of(function, headers)) for function in FUNCTIONS}
    silent = [f"{function}: {option[0]}" for function, options in functions.items()
              for option in options if "Set it " not in option[3]]
    if silent:
        sys.exit("generate_options.py: no 'Set it ...' tells when one needs " + ", ".join(silent))
    for target, lines in (arguments.cpp, cpp), (arguments.python, python):
        target.parent.mkdir(parents=True, exist_ok=True)
        target.write_text("\n".join(lines(functions, headers)) + "\n", encoding="utf-8")


if __name__ == "__main__":
    main()
