"""Conan 2: conan create packaging/conan. The library for C++ and C; the program is not in it."""

import os

from conan import ConanFile
from conan.tools.build import check_min_cppstd
from conan.tools.cmake import CMake, CMakeDeps, CMakeToolchain, cmake_layout
from conan.tools.files import copy, load

FOLDERS = ("src", "cmake", "bindings", "tools")
FILES = ("CMakeLists.txt", "CMakePresets.json", "LICENSE", "NOTICE")


class Thigma(ConanFile):
    name = "thigma"
    license = "Apache-2.0"
    description = "Six-degree-of-freedom haptic rendering with polygon models"
    package_type = "static-library"
    settings = "os", "arch", "compiler", "build_type"
    options = {"fPIC": [True, False]}
    default_options = {"fPIC": True}

    @property
    def _root(self):
        return os.path.join(self.recipe_folder, "..", "..")

    def set_version(self):
        line = load(self, os.path.join(self._root, "CMakeLists.txt")).split("project(thigma VERSION ")[1]
        self.version = line.split()[0]

    def export_sources(self):
        for folder in FOLDERS:
            copy(self, f"{folder}/*", self._root, self.export_sources_folder, excludes="*.pyc")
        for file in FILES:
            copy(self, file, self._root, self.export_sources_folder)

    def requirements(self):
        self.requires("eigen/3.4.0", transitive_headers=True)
        self.requires("nlohmann_json/3.11.3")
        self.requires("tomlplusplus/3.4.0")
        self.requires("zstd/1.5.5")

    def validate(self):
        check_min_cppstd(self, 20)

    def layout(self):
        cmake_layout(self)

    def generate(self):
        CMakeDeps(self).generate()
        toolchain = CMakeToolchain(self)
        for name in ("TESTS", "APPS", "EXPERIMENTS"):
            toolchain.cache_variables[f"THIGMA_BUILD_{name}"] = False
        toolchain.cache_variables["THIGMA_C"] = True
        toolchain.generate()

    def build(self):
        cmake = CMake(self)
        cmake.configure()
        cmake.build()

    def package(self):
        copy(self, "LICENSE", self.source_folder, os.path.join(self.package_folder, "licenses"))
        CMake(self).install()

    def package_info(self):
        # the library's own thigmaConfig.cmake is what its users find
        self.cpp_info.set_property("cmake_find_mode", "none")
        self.cpp_info.builddirs.append(os.path.join("lib", "cmake", "thigma"))
