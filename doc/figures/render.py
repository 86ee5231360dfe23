#!/usr/bin/env python3
# Copyright (c) 2026 The CCSweep authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Draws a decomposition: each volume_*.ply of a folder in a colour of its own, pulled apart.

    doc/figures/render.py DIR OUT.png [--before PART.ply] [--explode 0.35] [--view x,y,z] [--up x,y,z]
        [--size 1600x1200] [--edges]

Needs VTK for Python (Debian: python3-vtk9). Draws off screen; where no display can be opened, run it under xvfb-run.
"""
import argparse
import itertools
import pathlib
import sys

import vtkmodules.vtkInteractionStyle  # noqa: F401  (registers the factories of the renderer)
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401
from vtkmodules.vtkCommonDataModel import vtkBoundingBox, vtkVector3d
from vtkmodules.vtkFiltersCore import vtkFeatureEdges, vtkPolyDataNormals
from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkIOPLY import vtkPLYReader
from vtkmodules.vtkRenderingCore import (
    vtkActor,
    vtkLightKit,
    vtkPolyDataMapper,
    vtkRenderer,
    vtkRenderWindow,
    vtkWindowToImageFilter,
)

# Okabe and Ito's colours, told apart by colour-blind readers too.
COLOURS = ["#E69F00", "#56B4E9", "#009E73", "#F0E442", "#0072B2", "#D55E00", "#CC79A7", "#999999"]


def triple(text):
    values = [float(part) for part in text.split(",")]
    if len(values) != 3:
        raise argparse.ArgumentTypeError("three numbers with commas between them are needed")
    return values


def pixels(text):
    width, height = text.split("x")
    return int(width), int(height)


def rgb(colour):
    return [int(colour[i : i + 2], 16) / 255 for i in (1, 3, 5)]


def read(path):
    reader = vtkPLYReader()
    reader.SetFileName(str(path))
    reader.Update()
    mesh = reader.GetOutput()
    if mesh.GetNumberOfCells() == 0:
        sys.exit(f"{path} holds no faces")
    return mesh


def actor_of(mesh_port, colour, shift):
    mapper = vtkPolyDataMapper()
    mapper.SetInputConnection(mesh_port)
    mapper.ScalarVisibilityOff()
    actor = vtkActor()
    actor.SetMapper(mapper)
    actor.SetPosition(shift)
    actor.GetProperty().SetColor(colour)
    return actor


def add_volume(renderer, mesh, colour, shift, all_edges):
    # Split at the feature edges, so that walls stay flat and round faces look round.
    normals = vtkPolyDataNormals()
    normals.SetInputData(mesh)
    normals.SetFeatureAngle(30)
    normals.SplittingOn()
    surface = actor_of(normals.GetOutputPort(), rgb(colour), shift)
    surface.GetProperty().SetAmbient(0.25)
    surface.GetProperty().SetDiffuse(0.8)
    surface.GetProperty().SetEdgeVisibility(all_edges)
    renderer.AddActor(surface)

    features = vtkFeatureEdges()
    features.SetInputData(mesh)
    features.SetFeatureAngle(30)
    features.ColoringOff()
    lines = actor_of(features.GetOutputPort(), (0.1, 0.1, 0.1), shift)
    lines.GetProperty().SetLineWidth(3)
    lines.GetProperty().LightingOff()
    renderer.AddActor(lines)


def corners(bounds, shift):
    """The corners of a mesh's box, shifted."""
    pairs = [bounds[0:2], bounds[2:4], bounds[4:6]]
    return [[c + s for c, s in zip(corner, shift)] for corner in itertools.product(*pairs)]


def aim(renderer, points, options):
    """Looks along the view at all the points without perspective, so that parallel walls stay parallel."""
    view = vtkVector3d(options.view)
    view.Normalize()
    right = vtkVector3d(options.up).Cross(view)
    right.Normalize()
    up = view.Cross(right)
    ranges = []
    for axis in (right, up, view):
        heights = [axis.Dot(vtkVector3d(point)) for point in points]
        ranges.append((min(heights), max(heights)))
    middle = [sum(axis[i] * (low + high) / 2 for axis, (low, high) in zip((right, up, view), ranges)) for i in range(3)]
    width, height, depth = (high - low for low, high in ranges)

    camera = renderer.GetActiveCamera()
    camera.ParallelProjectionOn()
    left, bottom, right_end, top = renderer.GetViewport()
    aspect = (right_end - left) * options.size[0] / ((top - bottom) * options.size[1])
    camera.SetParallelScale(0.53 * max(height, width / aspect))
    camera.SetFocalPoint(middle)
    camera.SetPosition([m + depth * v for m, v in zip(middle, view)])
    camera.SetViewUp([up[i] for i in range(3)])
    renderer.ResetCameraClippingRange()


def scene(meshes, colours, explode, viewport, options):
    """A renderer of meshes that are pulled apart from the middle of all of them."""
    whole = vtkBoundingBox()
    for mesh in meshes:
        whole.AddBounds(mesh.GetBounds())
    centre = [0.0] * 3
    whole.GetCenter(centre)

    renderer = vtkRenderer()
    renderer.SetViewport(viewport)
    renderer.SetBackground(1, 1, 1)
    lights = vtkLightKit()
    lights.AddLightsToRenderer(renderer)
    points = []
    for i, mesh in enumerate(meshes):
        shift = [explode * (own - mid) for own, mid in zip(mesh.GetCenter(), centre)]
        add_volume(renderer, mesh, colours[i % len(colours)], shift, options.edges)
        points += corners(mesh.GetBounds(), shift)
    aim(renderer, points, options)
    return renderer


def draw(meshes, before, options):
    scenes = [scene(meshes, COLOURS, options.explode, (0.5 if before else 0, 0, 1, 1), options)]
    if before:
        scenes.append(scene([before], ["#B8C4CE"], 0, (0, 0, 0.5, 1), options))

    window = vtkRenderWindow()
    window.SetOffScreenRendering(1)
    window.SetMultiSamples(8)
    window.SetSize(options.size)
    for renderer in scenes:
        window.AddRenderer(renderer)
    window.Render()
    image = vtkWindowToImageFilter()
    image.SetInput(window)
    image.ReadFrontBufferOff()
    writer = vtkPNGWriter()
    writer.SetFileName(str(options.out))
    writer.SetInputConnection(image.GetOutputPort())
    writer.Write()


def main():
    parser = argparse.ArgumentParser(description="Draws a decomposition, pulled apart, as a PNG image.")
    parser.add_argument("folder", type=pathlib.Path, help="what `ccsweep decompose --out` wrote")
    parser.add_argument("out", type=pathlib.Path, help="the PNG file")
    parser.add_argument("--before", type=pathlib.Path, help="the part, to be drawn on the left")
    parser.add_argument("--explode", type=float, default=0.35, help="how far apart; 0 leaves the part together")
    parser.add_argument("--view", type=triple, default=[-1.2, -2.0, 1.1], help="from the part to the eye")
    parser.add_argument("--up", type=triple, default=[0.0, 0.0, 1.0])
    parser.add_argument("--size", type=pixels, default=(1600, 1200), metavar="WIDTHxHEIGHT")
    parser.add_argument("--edges", action="store_true", help="show the triangles")
    options = parser.parse_args()
    files = sorted(options.folder.glob("volume_*.ply"))
    if not files:
        sys.exit(f"{options.folder} holds no volume_*.ply")
    draw([read(path) for path in files], read(options.before) if options.before else None, options)


if __name__ == "__main__":
    main()
