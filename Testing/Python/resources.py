# SPDX-License-Identifier: BSD-3-Clause
"""What a process has: GL objects of the current context, and memory."""

import ctypes
import os

# What glIs... exists for, by the names that are asked for.
KINDS = ("Texture", "Buffer", "Framebuffer", "Renderbuffer", "VertexArray", "Query", "Program",
         "Shader", "Sampler", "TransformFeedback", "ProgramPipeline")


def find_gl():
    for name in ("libGL.so.1", "libOpenGL.so.0"):
        try:
            return ctypes.CDLL(name)
        except OSError:
            continue
    return None


def count_gl_objects(gl, up_to=4000):
    """By kind: drivers give out small numbers as names, and those of what is gone again."""
    counts = {}
    for kind in KINDS:
        ask = getattr(gl, "glIs" + kind, None)
        if ask is not None:
            ask.restype = ctypes.c_ubyte
            ask.argtypes = [ctypes.c_uint]
            counts[kind] = sum(ask(name) for name in range(1, up_to))
    return counts


class HeapFacts(ctypes.Structure):
    """The C library's struct mallinfo2."""

    _fields_ = [(name, ctypes.c_size_t) for name in (
        "arena", "ordblks", "smblks", "hblks", "hblkhd", "usmblks", "fsmblks", "uordblks",
        "fordblks", "keepcost")]


def heap_in_use():
    """Bytes that are allocated, of which the driver's and VTK's are a part; None where the C
    library doesn't say."""
    try:
        ask = ctypes.CDLL("libc.so.6").mallinfo2
    except (OSError, AttributeError):
        return None
    ask.restype = HeapFacts
    facts = ask()
    return facts.uordblks + facts.hblkhd


def resident():
    """Bytes of memory that the process has, freed ones given back; None where /proc doesn't say."""
    try:
        ctypes.CDLL("libc.so.6").malloc_trim(0)
        with open("/proc/self/statm") as file:
            return int(file.read().split()[1]) * os.sysconf("SC_PAGE_SIZE")
    except (OSError, AttributeError):
        return None
