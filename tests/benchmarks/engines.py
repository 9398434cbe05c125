"""Physics engines, each one function: it makes a scene and returns how the scene goes on.

It takes a scene, which load, the damping of the object and settings. What it returns takes seconds,
the magnitude of the load and the share of the preloads; it runs the scene so long under them, and
tells how far the object is from its start, at the origin: (x, y, turn) or (x, y, z, three turns).
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from importlib.util import find_spec
from itertools import chain
from typing import Any, TypeAlias

import numpy as np

from equilibrium.scenes import EngineScene

#: Runs a scene on: seconds, load, share of the preloads.
Advance: TypeAlias = Callable[[float, float, float], np.ndarray]


@dataclass(frozen=True)
class Setting:
    """An engine with its settings.

    Attributes:
        dimensions: of the grasps that it can hold.
        sample: it takes each such scene of those that are measured.
    """

    engine: str
    name: str
    make: Callable[..., Advance]
    options: dict[str, Any]
    dimensions: tuple[int, ...] = (2, 3)
    sample: int = 1


def mujoco_scene(scene: EngineScene, load: int, damping: float, **options: Any) -> Advance:
    """Make a scene in MuJoCo: cone, impratio, noslip iterations, time step."""
    import mujoco

    model = mujoco.MjModel.from_xml_string(scene.mjcf())
    option, step = model.opt, options.get("step", 2e-3)
    option.cone = getattr(mujoco.mjtCone, f"mjCONE_{options['cone'].upper()}")
    option.impratio = options.get("impratio", 1)
    option.noslip_iterations = options.get("noslip", 0)
    option.timestep = step
    data = mujoco.MjData(model)
    moves = len(scene.directions[load])
    springs = model.qpos_spring[-len(scene.grasp) :].copy()
    model.dof_damping[:moves] *= damping / scene.damping
    start, moved = data.qpos.copy(), np.zeros(model.nv)

    def advance(seconds: float, t: float, pressed: float) -> np.ndarray:
        data.ctrl[load] = t
        model.qpos_spring[-len(scene.grasp) :] = springs * pressed
        mujoco.mj_step(model, data, nstep=round(seconds / step))
        mujoco.mj_differentiatePos(model, moved, 1, start, data.qpos)
        return moved[:moves].copy()

    return advance


def pymunk_scene(scene: EngineScene, load: int, damping: float, **options: Any) -> Advance:
    """Make a scene in the plane in pymunk: iterations, time step."""
    import pymunk

    space = pymunk.Space()
    space.iterations, step = options["iterations"], options["step"]
    space.collision_slop = scene.size * 1e-6
    body = pymunk.Body(scene.mass, scene.mass * scene.size**2)
    centre = scene.centre[:2]
    body.position, origin = tuple(centre), tuple(-centre)
    space.add(body)
    fingers = []
    for i, (pad, given) in enumerate(zip(scene.pads, scene.fingers, strict=True)):
        alone = pymunk.ShapeFilter(categories=1 << i, mask=1 << i)
        normal, middle = np.array(given["axis"][:2]), np.array(pad["centre"][:2]) - centre
        along = np.array([-normal[1], normal[0]]) * pad["halves"][0]
        across = normal * pad["halves"][2]
        corners = [middle + s * along + r * across for s, r in ((1, 1), (1, -1), (-1, -1), (-1, 1))]
        flat = pymunk.Poly(body, [tuple(x) for x in corners])
        flat.friction, flat.filter = 1.0, alone
        finger = pymunk.Body(given["mass"], float("inf"))
        start = np.array(given["centre"][:2])
        finger.position = tuple(start)
        ball = pymunk.Circle(finger, given["radius"])
        ball.friction, ball.filter = given["friction"], alone
        ends = [tuple(start + s * normal * scene.size) for s in (-1, 1)]
        groove = pymunk.GrooveJoint(space.static_body, finger, *ends, (0, 0))
        space.add(flat, finger, ball, groove)
        fingers.append((finger, given, tuple(normal), tuple(start)))
    wrench = [float(x) for x in scene.directions[load]]
    turning = damping * scene.size**2

    def advance(seconds: float, t: float, pressed: float) -> np.ndarray:
        for _ in range(round(seconds / step)):
            for finger, given, (nx, ny), (x, y) in fingers:
                at, speed = finger.position, finger.velocity
                force = given["preload"] * pressed
                force -= given["stiffness"] * ((at.x - x) * nx + (at.y - y) * ny)
                force -= given["damping"] * (speed.x * nx + speed.y * ny)
                finger.force = force * nx, force * ny
            speed = body.velocity_at_local_point(origin)
            push = t * wrench[0] - damping * speed.x, t * wrench[1] - damping * speed.y
            # Forces act at the origin; pymunk takes them at the centre of mass.
            body.force, lever = push, body.local_to_world(origin) - body.position
            turn = t * wrench[2] - turning * body.angular_velocity
            body.torque = turn + lever.x * push[1] - lever.y * push[0]
            space.step(step)
        return np.array([*body.local_to_world(origin), body.angle])

    return advance


def drake_scene(scene: EngineScene, load: int, damping: float, **options: Any) -> Advance:
    """Make a scene in Drake: approximation of contact, time step."""
    from pydrake.common.value import Value
    from pydrake.geometry import Box, CollisionFilterDeclaration, GeometrySet, Sphere
    from pydrake.math import RigidTransform, RotationMatrix
    from pydrake.multibody import plant as plants, tree
    from pydrake.multibody.math import SpatialForce
    from pydrake.systems.analysis import Simulator
    from pydrake.systems.framework import DiagramBuilder

    step, flat = options["step"], scene.grasp.dimension == 2
    builder = DiagramBuilder()
    plant, shapes = plants.AddMultibodyPlantSceneGraph(builder, step)
    contact = getattr(plants.DiscreteContactApproximation, f"k{options['contact']}")
    plant.set_discrete_contact_approximation(contact)
    plant.mutable_gravity_field().set_gravity_vector([0, 0, 0])
    world, inertia = plant.world_frame(), tree.SpatialInertia.SolidSphereWithMass
    # A solid ball of this radius turns as hardly as the object.
    heavy = inertia(scene.mass, scene.size * np.sqrt(2.5)).Shift(-scene.centre)
    held = plant.AddRigidBody("object", heavy)
    turning = damping * scene.size**2
    if flat:
        held_by = tree.PlanarJoint("held", world, held.body_frame(), [damping, damping, turning])
    else:
        held_by = tree.QuaternionFloatingJoint("held", world, held.body_frame(), turning, damping)
    plant.AddJoint(held_by)
    fingers, pairs = [], []
    for i, (pad, given) in enumerate(zip(scene.pads, scene.fingers, strict=True)):
        rubs, axis = plants.CoulombFriction(*[given["friction"]] * 2), np.array(given["axis"])
        place = RigidTransform(RotationMatrix.MakeFromOneVector(axis, 2), pad["centre"])
        box = Box(*(2 * x for x in pad["halves"]))
        finger = plant.AddRigidBody(f"finger {i}", inertia(given["mass"], given["radius"]))
        start = tree.FixedOffsetFrame(f"start {i}", world, RigidTransform(given["centre"]))
        frames = plant.AddFrame(start), finger.body_frame()
        slide = tree.PrismaticJoint(f"slide {i}", *frames, axis, damping=given["damping"])
        spring = tree.PrismaticSpring(plant.AddJoint(slide), 0, given["stiffness"])
        plant.AddForceElement(spring)
        fingers.append((finger, given["preload"] * axis))
        ball, here = Sphere(given["radius"]), RigidTransform()
        touching = (held, place, box, f"pad {i}"), (finger, here, ball, f"ball {i}")
        pairs.append([plant.RegisterCollisionGeometry(*shape, rubs) for shape in touching])
    plant.Finalize()
    allowed = CollisionFilterDeclaration().ExcludeWithin(GeometrySet([*chain(*pairs)]))
    for one, other in pairs:
        allowed.AllowBetween(GeometrySet(one), GeometrySet(other))
    shapes.collision_filter_manager().Apply(allowed)
    simulator = Simulator(builder.Build())
    simulator.Initialize()
    context = plant.GetMyMutableContextFromRoot(simulator.get_mutable_context())
    wrench = [float(x) for x in scene.directions[load]]
    force = np.array([*wrench[:2], 0] if flat else wrench[:3])
    torque = np.array([0, 0, wrench[2]] if flat else wrench[3:])

    def push(body: Any, force: Any, torque: Any) -> Any:
        made = plants.ExternallyAppliedSpatialForce()
        made.body_index, made.F_Bq_W = body.index(), SpatialForce(torque, force)
        return made

    def advance(seconds: float, t: float, pressed: float) -> np.ndarray:
        pushes = [push(held, t * force, t * torque)]
        pushes += [push(finger, pressed * preload, np.zeros(3)) for finger, preload in fingers]
        plant.get_applied_spatial_force_input_port().FixValue(context, Value(pushes))
        simulator.AdvanceTo(simulator.get_context().get_time() + round(seconds / step) * step)
        pose = plant.EvalBodyPoseInWorld(context, held)
        turned, moved = pose.rotation().ToAngleAxis(), pose.translation()
        turn = turned.angle() * turned.axis()
        return np.array([*moved[:2], turn[2]] if flat else [*moved, *turn])

    return advance


def settings() -> Iterator[Setting]:
    """Yield what is measured; an engine that is not installed is left out, and said."""
    for cone in ("elliptic", "pyramidal"):
        for options in (
            {"impratio": 1},
            {"impratio": 10},
            {"impratio": 100},
            {"impratio": 10, "noslip": 10},
            {"impratio": 10, "step": 5e-4},
        ):
            words = ", ".join(f"{key} {value:g}" for key, value in options.items())
            often = 1 if options.keys() == {"impratio"} else 4
            whole = {"cone": cone, **options}
            yield Setting("mujoco", f"{cone}, {words}", mujoco_scene, whole, sample=often)
    for iterations in (10, 50):
        options = {"iterations": iterations, "step": 2e-3}
        yield Setting("pymunk", f"{iterations} iterations", pymunk_scene, options, (2,), 2)
    if find_spec("pydrake"):
        for contact in ("Sap", "Similar"):
            options = {"contact": contact, "step": 2e-3}
            yield Setting("drake", contact, drake_scene, options, sample=6)
