# SPDX-License-Identifier: BSD-3-Clause
"""Every raw OpenGL call of the module is known here by how what it changes is given back, so that
no stage can leave anything changed by a call that nobody has thought about."""

import pathlib
import re
import unittest

MODULE = pathlib.Path(__file__).parents[2] / "vtkRTWShadows"
RECORD = "GL/rtwStateRecord.cxx"

# Noted by StateRecord before they are changed: only it may call these.
NOTED = """glActiveTexture glBindBuffer glBindBufferBase glBindBufferRange glBindSampler glBindTexture
    glPixelStorei""".split()
# But for these, which say by themselves why they may.
EXCEPTIONS = {
    ("GL/rtwStateGuard.cxx", "glBindBuffer"),  # the guard gives the array buffer back by itself
    ("GL/rtwDrawing.cxx", "glBindBuffer"),  # the index buffer is part of a vertex array of ours
}
# Given back by vtkOpenGLState, which StateGuard pushes and pops, or by StateGuard itself.
GUARDED = """glBindFramebuffer glBindVertexArray glBlendEquation glBlendFuncSeparate glColorMask
    glDepthFunc glDepthMask glUseProgram glViewport""".split()
# Capabilities that vtkOpenGLState gives back; all others go by SetEnabled.
GUARDED_CAPABILITIES = """GL_BLEND GL_CULL_FACE GL_DEPTH_TEST GL_SCISSOR_TEST
    GL_STENCIL_TEST""".split()
# They begin and end in one function.
PAIRED = """glBeginConditionalRender glBeginQuery glEndConditionalRender glEndQuery""".split()
# They change objects of ours alone: those that are named or were bound just before.
OURS = """glAttachShader glBufferData glBufferSubData glClearBufferData glClearBufferfv
    glClearBufferuiv glCompileShader glCopyBufferSubData glCopyTexSubImage2D glCreateProgram
    glCreateShader glDeleteBuffers glDeleteFramebuffers glDeleteProgram glDeleteQueries
    glDeleteShader glDeleteSync glDeleteTextures glDeleteVertexArrays glDetachShader glDrawBuffers
    glEnableVertexAttribArray glFenceSync glFramebufferTexture2D glFramebufferTextureLayer
    glGenBuffers glGenFramebuffers glGenQueries glGenTextures glGenVertexArrays glLinkProgram
    glMapBufferRange glQueryCounter glReadBuffer glShaderSource glTexBuffer glTexImage2D
    glTexImage2DMultisample glTexImage3D glTexParameteri glUniform1f glUniform1i glUniform1iv
    glUniform2f glUniform2fv glUniform2i glUniform3f glUniform4f glUniform4fv
    glUniformBlockBinding glUniformMatrix4fv glUnmapBuffer glVertexAttribDivisor
    glVertexAttribPointer""".split()
# They change no state.
HARMLESS = re.compile(
    r"gl(Get\w+|Is\w+|CheckFramebufferStatus|ClientWaitSync|Dispatch\w+|Draw(Arrays|Elements)\w*|"
    r"Finish|Flush|MemoryBarrier|MultiDraw\w+)$")

CALL = re.compile(r"(?<![\w.>])(gl[A-Z]\w*)\s*\(\s*([^,;)]*)")


def calls():
    for path in sorted(MODULE.glob("*/*.cxx")):
        name = path.relative_to(MODULE).as_posix()
        code = re.sub(r"//.*", "", path.read_text())
        for function, argument in CALL.findall(code):
            yield name, function, argument.strip()


class TestRawCalls(unittest.TestCase):
    def test_there_are_some(self):
        self.assertGreater(len(list(calls())), 100)

    def test_what_is_noted_is_changed_in_one_place(self):
        for name, function, argument in calls():
            if function in NOTED and name != RECORD and (name, function) not in EXCEPTIONS:
                self.fail(f"{name} calls {function}({argument}...): {RECORD} has a function for it")

    def test_exceptions_are_what_they_are_for(self):
        allowed = {"GL/rtwStateGuard.cxx": "GL_ARRAY_BUFFER",
                   "GL/rtwDrawing.cxx": "GL_ELEMENT_ARRAY_BUFFER"}
        for name, function, argument in calls():
            if (name, function) in EXCEPTIONS:
                self.assertEqual(argument, allowed[name], name)

    def test_capabilities(self):
        for name, function, argument in calls():
            if function in ("glEnable", "glDisable") and name != RECORD:
                self.assertIn(argument, GUARDED_CAPABILITIES,
                              f"{name} calls {function}: SetEnabled gives it back")

    def test_all_calls_are_known(self):
        known = {*NOTED, *GUARDED, *PAIRED, *OURS, "glEnable", "glDisable"}
        for name, function, argument in calls():
            self.assertTrue(
                function in known or HARMLESS.match(function),
                f"{name} calls {function}({argument}...): say here how what it changes is given back")


if __name__ == "__main__":
    unittest.main()
