# SPDX-License-Identifier: BSD-3-Clause
"""Tables and plots of what shadow-benchmark measured."""
