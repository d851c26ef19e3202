"""What pip and build call to make the wheel: meson-python with the options of a wheel. Without what the build
needs they say so in one line."""

import importlib
import importlib.util
import os
import shutil
import subprocess
import sys

OPTIONS = ["-Dwheel=true", "-Dapp=disabled", "-Dtests=false"]

#: Where Debian keeps meson-python.
DEBIAN = "/usr/lib/python3/dist-packages"

#: What pkg-config must know, and compilers must find; Debian's packages of it.
LIBRARIES = {
    "glib-2.0": "libglib2.0-dev", "gio-2.0": "libglib2.0-dev", "libcjson": "libcjson-dev",
    "libxml-2.0": "libxml2-dev", "lapack": "liblapack-dev", "cairo": "libcairo2-dev",
    "pangocairo": "libpango1.0-dev", "zlib": "zlib1g-dev",
    "gdk-pixbuf-2.0": "libgdk-pixbuf-2.0-dev", "gsl": "libgsl-dev", "sqlite3": "libsqlite3-dev",
}
HEADERS = {"geos_c.h": "libgeos-dev", "gif_lib.h": "libgif-dev", "cholmod.h": "libsuitesparse-dev"}
PROGRAMS = {"cc": "gcc", "pkg-config": "pkg-config", "ninja": "ninja-build",
            "glib-compile-resources": "libglib2.0-dev-bin"}


def _finds(command, text=None):
    return subprocess.run(command, input=text, text=True, check=False,
                          capture_output=True).returncode == 0


def lacks():
    """Packages of Debian that the build needs and does not find."""
    missing = [package for program, package in PROGRAMS.items() if not shutil.which(program)]
    if not missing:
        missing += [package for name, package in LIBRARIES.items()
                    if not _finds(["pkg-config", "--exists", name])]
        missing += [package for header, package in HEADERS.items()
                    if not _finds(["cc", "-E", "-I/usr/include/suitesparse", "-"],
                                  f"#include <{header}>")]
    return sorted(set(missing))


def _settings(given):
    missing = lacks()
    if missing:
        raise SystemExit(f"quoin: the build lacks {', '.join(missing)} (packages of Debian; "
                         "tools/setup.sh installs them)")
    given = dict(given or {})
    options = given.get("setup-args", [])
    given["setup-args"] = OPTIONS + ([options] if isinstance(options, str) else list(options))
    return given


def _mesonpy():
    """meson-python, of the system where pip shuts its packages out, with Meson; None where there is none."""
    if importlib.util.find_spec("mesonpy") is None:
        sys.path.append(DEBIAN)
        if importlib.util.find_spec("mesonpy") is None:
            sys.path.remove(DEBIAN)
            return None
        os.environ.pop("PYTHONPATH", None)  # by which pip shuts them out of Meson too
    return importlib.import_module("mesonpy")


def build_wheel(directory, config_settings=None, metadata_directory=None):
    settings = _settings(config_settings)
    return _mesonpy().build_wheel(directory, settings, metadata_directory)


def build_sdist(directory, config_settings=None):
    return _mesonpy().build_sdist(directory, _settings(config_settings))


def get_requires_for_build_wheel(config_settings=None):
    """What pip is to fetch: nothing where the system has it, so that no network is needed. Ninja and
    patchelf of the system will do."""
    _settings(config_settings)
    return [] if _mesonpy() else ["meson-python >= 0.12"]


get_requires_for_build_sdist = get_requires_for_build_wheel
