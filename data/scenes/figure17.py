"""Prints the scene figure17.csg, which is drawn by arithmetic alone, the same each time:

    python3 data/scenes/figure17.py > data/scenes/figure17.csg
"""

from math import cos, pi, sin, sqrt

GOLDEN_ANGLE = pi * (3 - sqrt(5))
COLUMNS = 12
COLUMN_RING = 3.6  # distance of the columns from the temple's axis
COLUMN_TOP = 3.5
DOME_RADIUS = 3.5
DOME_FOOT = 5.05

HEADER = """\
// Wyvill and Trotman 1990, Figure 17: a complex scene with more than 900 primitives, with
// reflection and texture; here a round temple, with an open dome, of {count} primitives.
// Right: each ball, column and step is whole, and shows again in the floor. Wrong: speckle where
// primitives touch or coincide, as the steps and the columns that stand on one another do.
// Printed by figure17.py.
"""

MATERIALS = """\
material("floor", color=[0.30, 0.33, 0.38], texture="checker", second_color=[0.16, 0.18, 0.23],
         grain=1.3, mirror=0.40, specular=0);
material("marble", color=[0.93, 0.92, 0.88], texture="marble", second_color=[0.42, 0.46, 0.50],
         grain=0.8, specular=0.4, shininess=60, mirror=0.05);
material("rose marble", color=[0.88, 0.70, 0.62], texture="marble",
         second_color=[0.60, 0.36, 0.34], grain=0.5, specular=0.4, shininess=60);
material("wood", color=[0.62, 0.38, 0.20], texture="wood", second_color=[0.36, 0.20, 0.10],
         grain=0.12);
material("tiles", color=[0.92, 0.88, 0.78], texture="checker", second_color=[0.20, 0.34, 0.48],
         grain=0.35, specular=0.3);
material("gold", color=[0.88, 0.66, 0.22], mirror=0.30, specular=0.8, shininess=70);
material("silver", color=[0.86, 0.88, 0.92], mirror=0.55, specular=0.9, shininess=120);
material("lapis", color=[0.14, 0.26, 0.66], specular=0.6, shininess=60);
material("jade", color=[0.20, 0.58, 0.40], specular=0.6, shininess=60);
material("ruby", color=[0.76, 0.12, 0.16], specular=0.7, shininess=80);
material("pearl", color=[0.95, 0.92, 0.87], mirror=0.12, specular=0.7, shininess=90);
material("glass", color=[0.85, 0.95, 1.00, 0.10], index=3/2, mirror=0.10, specular=0.9,
         shininess=200);
"""

VIEW = """\
camera(eye=[5, -19, 6.2], look_at=[0, 0, 3.9], up=[0, 0, 1], fov=35);
light(position=[-14, -18, 24]);
light(position=[20, -12, 12], color=[0.45, 0.42, 0.38]);
background(color=[0.42, 0.58, 0.80]);
"""


def number(value):
    """At most four decimals."""
    return f"{round(value, 4) + 0:g}"


def vector(*values):
    return "[" + ", ".join(number(v) for v in values) + "]"


class Scene:
    def __init__(self):
        self.lines = []
        self.count = 0

    def primitive(self, material, place, text):
        self.count += 1
        line = f'material("{material}") translate({vector(*place)}) {text};'
        self.lines.append(line if len(line) <= 100 else line.replace(") ", ")\n  ", 1))

    def ball(self, material, place, radius):
        self.primitive(material, place, f"sphere(r={number(radius)})")

    def cylinder(self, material, place, height, radius):
        self.primitive(material, place, f"cylinder(h={number(height)}, r={number(radius)})")

    def frustum(self, material, place, height, r1, r2):
        sizes = f"h={number(height)}, r1={number(r1)}, r2={number(r2)}"
        self.primitive(material, place, f"cylinder({sizes})")

    def box(self, material, place, degrees, size):
        text = f"rotate({number(degrees)}) cube({vector(*size)}, center=true)"
        self.primitive(material, place, text)

    def ring(self, material, place, major, minor):
        self.primitive(material, place, f"torus(R={number(major)}, r={number(minor)})")


def around(radius, angle, z):
    return (radius * cos(angle), radius * sin(angle), z)


def steps(scene):
    """Three steps, each standing on the one below."""
    scene.cylinder("tiles", (0, 0, 0), 0.3, 5.2)
    scene.cylinder("marble", (0, 0, 0.3), 0.3, 4.8)
    scene.cylinder("rose marble", (0, 0, 0.6), 0.2, 4.4)


def column(scene, angle):
    def at(z):
        return around(COLUMN_RING, angle, z)

    degrees = angle * 180 / pi
    scene.box("marble", at(0.9), degrees, (0.8, 0.8, 0.2))
    scene.ring("gold", at(1.08), 0.28, 0.09)
    scene.cylinder("marble", at(1), COLUMN_TOP - 1.25, 0.26)
    scene.frustum("gold", at(COLUMN_TOP - 0.25), 0.25, 0.26, 0.42)
    scene.box("marble", at(COLUMN_TOP + 0.06), degrees, (0.8, 0.8, 0.12))


def arch(scene, angle, beads):
    """A half circle of balls from a column to the next."""
    step = 2 * pi / COLUMNS
    half = COLUMN_RING * sin(step / 2)
    for i in range(beads):
        bow = pi * i / (beads - 1)
        turn = angle + step / 2 - cos(bow) * step / 2
        z = COLUMN_TOP + 0.22 + half * sin(bow)
        scene.ball(("pearl", "lapis")[i % 2], around(COLUMN_RING, turn, z), 0.125)


def cornice(scene):
    """What the dome stands on: a ring, with balls upon it."""
    z = DOME_FOOT - 0.2
    scene.ring("marble", (0, 0, z), COLUMN_RING, 0.2)
    count = 72
    for i in range(count):
        place = around(COLUMN_RING, 2 * pi * i / count, z + 0.27)
        scene.ball(("gold", "ruby", "gold", "jade")[i % 4], place, 0.13)


def dome(scene, rows):
    """Rows of balls that turn as they rise, so that they make spirals."""
    colors = ("lapis", "pearl", "gold", "pearl")
    widest = 48
    for row in range(rows):
        height = (pi / 2) * (row + 0.9) / (rows + 0.6)
        radius = DOME_RADIUS * cos(height)
        count = 4 * max(2, round(widest * cos(height) / 4))
        for i in range(count):
            place = around(radius, 2 * pi * (i + row / 2) / count,
                           DOME_FOOT + DOME_RADIUS * sin(height))
            scene.ball(colors[(i + row) % 4], place, 0.21 - 0.07 * row / rows)
    top = DOME_FOOT + DOME_RADIUS
    scene.ball("gold", (0, 0, top + 0.1), 0.34)
    scene.frustum("gold", (0, 0, top + 0.35), 0.9, 0.14, 0)


def fountain(scene):
    """A glass ball on a pedestal, with two spirals of balls about it."""
    scene.cylinder("wood", (0, 0, 0.8), 0.25, 1.3)
    scene.frustum("rose marble", (0, 0, 1.05), 1.1, 0.7, 0.35)
    scene.ball("glass", (0, 0, 2.9), 0.85)
    scene.ball("ruby", (0, 0, 2.9), 0.3)
    count = 56
    for i in range(count):
        rise = i / (count - 1)
        for arm, material in enumerate(("silver", "gold")):
            place = around(1.65 - 0.75 * rise, 5 * pi * rise + arm * pi, 0.95 + 3.6 * rise)
            scene.ball(material, place, 0.12)


def garden(scene, count):
    """Balls on the floor, each the golden angle on from the one before."""
    colors = ("ruby", "jade", "silver", "gold", "lapis")
    for i in range(count):
        distance = sqrt(36 + 0.62 * i)
        radius = 0.17 + 0.11 * (i % 5) / 4
        place = around(distance, i * GOLDEN_ANGLE, radius)
        scene.ball(colors[i % 5], place, radius)


def lanterns(scene):
    """Boxes around the temple, each with a post, a dish and a ball."""
    count = 8
    for i in range(count):
        angle = 2 * pi * (i + 0.37) / count

        def at(z):
            return around(5.65, angle, z)

        scene.box("wood", at(0.2), angle * 180 / pi, (0.5, 0.5, 0.4))
        scene.cylinder("gold", at(0.4), 0.7, 0.06)
        scene.frustum("gold", at(1.1), 0.15, 0.06, 0.24)
        scene.ball("pearl", at(1.42), 0.24)


def temple():
    scene = Scene()
    scene.count += 1
    scene.lines.append('material("floor") halfspace(normal=[0, 0, 1], offset=0);')
    steps(scene)
    for i in range(COLUMNS):
        angle = 2 * pi * (i + 0.23) / COLUMNS
        column(scene, angle)
        arch(scene, angle, 15)
    cornice(scene)
    dome(scene, 11)
    fountain(scene)
    garden(scene, 170)
    lanterns(scene)
    return scene


if __name__ == "__main__":
    SCENE = temple()
    print(HEADER.format(count=SCENE.count) + MATERIALS)
    print("\n".join(SCENE.lines) + "\n")
    print(VIEW, end="")
