"""Makes room.glb with Blender as a Python module (`pip install bpy`): python room.py room.glb.

Blender's coordinates: meters, z up. The room is 6 m wide (x), 5 m deep (y) and 3 m high (z).
"""

import math
import sys

import bpy

bpy.ops.wm.read_factory_settings(use_empty=True)


def material(name, color, metallic=0.0, roughness=1.0, emission=0.0):
    made = bpy.data.materials.new(name)
    made.use_nodes = True
    shader = made.node_tree.nodes["Principled BSDF"]
    shader.inputs["Base Color"].default_value = (*color, 1)
    shader.inputs["Metallic"].default_value = metallic
    shader.inputs["Roughness"].default_value = roughness
    if emission:
        shader.inputs["Emission Color"].default_value = (*color, 1)
        shader.inputs["Emission Strength"].default_value = emission
    return made


def planks():
    """A floor of wooden planks, as an image of 96 by 96 pixels."""
    size = 96
    image = bpy.data.images.new("planks", size, size)
    tones = [0.62, 0.74, 0.55, 0.68]
    pixels = []
    for y in range(size):
        row, at = divmod(y, size // 4)
        joint = (row * 41) % size
        for x in range(size):
            seam = at == 0 or x == joint
            tone = tones[(row + (2 if x < joint else 0)) % 4] * (0.6 if seam else 1.0)
            pixels += [tone, 0.68 * tone, 0.42 * tone, 1.0]
    image.pixels = pixels
    image.pack()
    made = material("wood floor", (1, 1, 1))
    texture = made.node_tree.nodes.new("ShaderNodeTexImage")
    texture.image = image
    made.node_tree.links.new(texture.outputs["Color"], made.node_tree.nodes["Principled BSDF"].inputs["Base Color"])
    return made


def add(name, vertices, faces, materials, uv=None, smooth=False, place=(0, 0, 0), turn=0.0):
    mesh = bpy.data.meshes.new(name)
    mesh.from_pydata(vertices, [], faces)
    materials = materials if isinstance(materials, list) else [(materials, len(faces))]
    index = 0
    for slot, (each, count) in enumerate(materials):
        mesh.materials.append(each)
        for face in mesh.polygons[index : index + count]:
            face.material_index = slot
        index += count
    if uv:
        layer = mesh.uv_layers.new()
        for face in mesh.polygons:
            for corner in face.loop_indices:
                layer.data[corner].uv = uv(vertices[mesh.loops[corner].vertex_index])
    for face in mesh.polygons:
        face.use_smooth = smooth
    return show(name, mesh, place, turn)


def show(name, mesh, place, turn=0.0):
    placed = bpy.data.objects.new(name, mesh)
    placed.location = place
    placed.rotation_euler = (0, 0, math.radians(turn))
    bpy.context.collection.objects.link(placed)
    return placed


def boxes(*corners):
    """Vertices and faces of boxes, each from its lowest to its highest corner."""
    vertices, faces = [], []
    for (x0, y0, z0), (x1, y1, z1) in corners:
        n = len(vertices)
        vertices += [(x, y, z) for z in (z0, z1) for x, y in ((x0, y0), (x1, y0), (x1, y1), (x0, y1))]
        sides = [(3, 2, 1, 0), (4, 5, 6, 7), (0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6), (3, 0, 4, 7)]
        faces += [tuple(n + i for i in side) for side in sides]
    return vertices, faces


def lathe(profile, around=20):
    """A surface of revolution of (radius, height), open at the top."""
    vertices = []
    for radius, height in profile:
        for k in range(around):
            angle = 2 * math.pi * k / around
            vertices.append((radius * math.cos(angle), radius * math.sin(angle), height))
    faces = []
    for ring in range(len(profile) - 1):
        for k in range(around):
            next_k = (k + 1) % around
            a, b = ring * around, (ring + 1) * around
            faces.append((a + k, a + next_k, b + next_k, b + k))
    return vertices, faces


plaster = material("plaster", (0.78, 0.72, 0.62))
white = material("white", (0.85, 0.85, 0.83))
oak = material("oak", (0.42, 0.24, 0.11), roughness=0.6)
red = material("red", (0.55, 0.06, 0.05))
blue = material("blue", (0.06, 0.16, 0.42))
green = material("green", (0.09, 0.3, 0.14))
china = material("china", (0.75, 0.42, 0.14), roughness=0.6)
silver = material("silver", (0.9, 0.9, 0.9), metallic=1.0, roughness=0.0)
lamp = material("lamp", (1.0, 0.86, 0.66), emission=14.0)

W, D, H = 3.0, 2.5, 3.0
quad = [(0, 1, 2, 3)]
add("Floor", [(-W, -D, 0), (W, -D, 0), (W, D, 0), (-W, D, 0)], quad, planks(), uv=lambda v: (v[0] / 1.5, v[1] / 1.5))
add("Ceiling", [(-W, -D, H), (-W, D, H), (W, D, H), (W, -D, H)], quad, white)
walls = [(-W, D, 0), (W, D, 0), (W, D, H), (-W, D, H), (-W, -D, 0), (W, -D, 0), (W, -D, H), (-W, -D, H)]
add("Walls", walls, [(0, 1, 2, 3), (5, 4, 7, 6), (4, 0, 3, 7), (1, 5, 6, 2)], plaster)
add("Rug", *boxes(((-1.5, -1.0, 0), (1.5, 1.0, 0.015))), red)
add("Table", *boxes(((-0.7, -0.4, 0.7), (0.7, 0.4, 0.75)), *(((x, y, 0), (x + 0.06, y + 0.06, 0.7))
    for x in (-0.66, 0.6) for y in (-0.36, 0.3))), oak, place=(-1.95, 1.85, 0))
chair = boxes(((-0.22, -0.22, 0.43), (0.22, 0.22, 0.47)), ((-0.22, 0.18, 0.47), (0.22, 0.22, 0.95)),
              *(((x, y, 0), (x + 0.04, y + 0.04, 0.43)) for x in (-0.22, 0.18) for y in (-0.22, 0.18)))
first = add("Chair", *chair, oak, place=(-2.2, 1.1, 0), turn=165)
show("Chair 2", first.data, (-1.5, 1.05, 0), 200)
add("Vase", *lathe([(0.0, 0.0), (0.09, 0.0), (0.15, 0.12), (0.16, 0.22), (0.1, 0.34), (0.07, 0.4), (0.1, 0.46)]),
    china, smooth=True, place=(-1.8, 1.9, 0.75))
shelf = [((-0.6, -0.15, z), (0.6, 0.15, z + 0.03)) for z in (0.0, 0.5, 1.0, 1.5, 1.97)]
shelf += [((-0.63, -0.15, 0), (-0.6, 0.15, 2)), ((0.6, -0.15, 0), (0.63, 0.15, 2))]
books, colors, x = [], {0: [], 1: [], 2: []}, -0.58
for board in (0.53, 1.03, 1.53):
    x = -0.58
    for k in range(11):
        width, height = 0.05 + 0.012 * ((k * 7) % 5), 0.26 + 0.02 * ((k * 5) % 6)
        colors[(k * k + int(board * 10)) % 3].append(((x, -0.12, board), (x + width, 0.1, board + height)))
        x += width + 0.004
parts = shelf + colors[0] + colors[1] + colors[2]
slots = [(oak, 6 * len(shelf)), (red, 6 * len(colors[0])), (blue, 6 * len(colors[1])), (green, 6 * len(colors[2]))]
add("Shelf", *boxes(*parts), slots, place=(1.6, 2.33, 0))
add("Mirror", [(0, 0, 0), (0, 1.2, 0), (0, 1.2, 1.5), (0, 0, 1.5)], quad, silver, place=(-2.98, -0.7, 0.8))
add("Lamp", *boxes(((-0.5, -0.3, 2.93), (0.5, 0.3, 2.97))), lamp, place=(0, 0, 0))

camera = bpy.data.objects.new("Camera", bpy.data.cameras.new("Camera"))
camera.data.lens_unit = "FOV"
camera.data.angle = math.radians(75)
camera.location = (1.9, -2.1, 1.6)
aim = bpy.data.objects.new("Aim", None)
aim.location = (-0.25, 0.6, 1.2)
follow = camera.constraints.new("TRACK_TO")
follow.target, follow.track_axis, follow.up_axis = aim, "TRACK_NEGATIVE_Z", "UP_Y"
light = bpy.data.objects.new("Bulb", bpy.data.lights.new("Bulb", "POINT"))
light.data.energy = 180
light.data.color = (1.0, 0.9, 0.75)
light.location = (0, 0, 2.85)
for each in (camera, aim, light):
    bpy.context.collection.objects.link(each)
bpy.context.scene.camera = camera
bpy.context.scene.render.resolution_x, bpy.context.scene.render.resolution_y = 480, 360

bpy.ops.export_scene.gltf(
    filepath=sys.argv[1], export_format="GLB", export_cameras=True, export_lights=True, export_yup=True,
    export_import_convert_lighting_mode="COMPAT", export_animations=False, export_apply=True,
)
