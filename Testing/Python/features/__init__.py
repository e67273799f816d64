# SPDX-License-Identifier: BSD-3-Clause
"""Scenes, each with a feature of VTK in it, which our passes must leave as VTK draws it."""
