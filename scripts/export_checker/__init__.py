# SPDX-License-Identifier: MIT
"""What scripts/verify-export is made of: it proves how far a controller that runs an exported file departs from the
designed motion or cam.

Everything follows from the scene, the motion of the result and the text of the file. Nothing here shares code with
the C++ programs.
"""
