"""Physics engines, each one function: it runs a scene under one load.

It takes a scene, which load, its magnitude, whether the preloads grow with it, a rule and settings,
and returns velocities of the object near the end, (x, y, turn) or (x, y, z, three turns).
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from importlib.util import find_spec
from itertools import chain
from typing import Any

import numpy as np

from equilibrium.scenes import FREQUENCY, EngineScene

#: The load grows in so many steps.
PARTS = 50


@dataclass(frozen=True)
class Rule:
    """When a load slips.

    Attributes:
        share: damping carries this much more of it than of a quarter of it.
        ramp: seconds over which a load grows; it is held for twice as long, and the last quarter of
            that is looked at.
        damping: of the object, times that of the scene.
    """

    share: float = 1 / 100
    ramp: float = 20 / FREQUENCY
    damping: float = 1


@dataclass(frozen=True)
class Setting:
    """An engine with its settings.

    Attributes:
        dimensions: of the grasps that it can hold.
        sample: it takes each such scene of those that are measured.
    """

    engine: str
    name: str
    run: Callable[..., np.ndarray]
    options: dict[str, Any]
    dimensions: tuple[int, ...] = (2, 3)
    sample: int = 1


def mujoco_run(
    scene: EngineScene, load: int, t: float, together: bool, rule: Rule, **options: Any
) -> np.ndarray:
    """Run a scene in MuJoCo: cone, impratio, noslip iterations, time step."""
    import mujoco

    model = mujoco.MjModel.from_xml_string(scene.mjcf())
    option = model.opt
    option.cone = getattr(mujoco.mjtCone, f"mjCONE_{options['cone'].upper()}")
    option.impratio = options.get("impratio", 1)
    option.noslip_iterations = options.get("noslip", 0)
    option.timestep = options.get("step", 2e-3)
    data = mujoco.MjData(model)
    moves = 3 if scene.grasp.dimension == 2 else 6
    places = 3 if moves == 3 else 7
    springs, steps = model.qpos_spring[places:].copy(), round(rule.ramp / option.timestep)
    model.dof_damping[:moves] *= rule.damping
    if not together:
        mujoco.mj_step(model, data, nstep=steps)
    for part in range(1, PARTS + 1):
        data.ctrl[load] = t * part / PARTS
        if together:
            model.qpos_spring[places:] = springs * part / PARTS
        mujoco.mj_step(model, data, nstep=steps // PARTS)
    mujoco.mj_step(model, data, nstep=steps * 3 // 2)
    before = data.qpos.copy()
    mujoco.mj_step(model, data, nstep=steps // 2)
    moved = np.zeros(moves)
    mujoco.mj_differentiatePos(model, whole := np.zeros(model.nv), 1, before, data.qpos)
    moved[:] = whole[:moves]
    return moved / (steps // 2 * option.timestep)


def pymunk_run(
    scene: EngineScene, load: int, t: float, together: bool, rule: Rule, **options: Any
) -> np.ndarray:
    """Run a scene in the plane in pymunk: iterations, time step."""
    import pymunk

    space = pymunk.Space()
    space.iterations = options["iterations"]
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
        fingers.append((finger, given, normal, start))
    wrench, damping = [t * float(x) for x in scene.directions[load]], rule.damping * scene.damping
    step, steps = options["step"], round(rule.ramp / options["step"])

    def advance(number: int, share: float, pressed: float) -> None:
        for _ in range(number):
            for finger, given, normal, start in fingers:
                out = float(np.dot(finger.position - start, normal))
                force = given["preload"] * pressed - given["stiffness"] * out
                force -= given["damping"] * float(np.dot(finger.velocity, normal))
                finger.force = tuple(force * normal)
            x, y = body.velocity_at_local_point(origin)
            push = np.array(wrench[:2]) * share - damping * np.array([x, y])
            # Forces act at the origin; pymunk takes them at the centre of mass.
            body.force = tuple(push)
            turn = wrench[2] * share - damping * scene.size**2 * body.angular_velocity
            lever = np.array(body.local_to_world(origin)) - body.position
            body.torque = turn + float(lever[0] * push[1] - lever[1] * push[0])
            space.step(step)

    if not together:
        advance(steps, 0, 1)
    for part in range(1, PARTS + 1):
        advance(steps // PARTS, part / PARTS, part / PARTS if together else 1)
    advance(steps * 3 // 2, 1, 1)
    place = lambda: np.array([*body.local_to_world(origin), body.angle])  # noqa: E731
    before = place()
    advance(steps // 2, 1, 1)
    return (place() - before) / (steps // 2 * step)


def drake_run(
    scene: EngineScene, load: int, t: float, together: bool, rule: Rule, **options: Any
) -> np.ndarray:
    """Run a scene in Drake: approximation of contact, time step."""
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
    damping = rule.damping * scene.damping
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

    def advance(number: int, share: float, pressed: float) -> None:
        pushes = [push(held, t * share * force, t * share * torque)]
        pushes += [push(finger, pressed * preload, np.zeros(3)) for finger, preload in fingers]
        plant.get_applied_spatial_force_input_port().FixValue(context, Value(pushes))
        simulator.AdvanceTo(simulator.get_context().get_time() + number * step)

    def place_now() -> RigidTransform:
        return plant.EvalBodyPoseInWorld(context, held)

    steps = round(rule.ramp / step)
    if not together:
        advance(steps, 0, 1)
    for part in range(1, PARTS + 1):
        advance(steps // PARTS, part / PARTS, part / PARTS if together else 1)
    advance(steps * 3 // 2, 1, 1)
    before = place_now()
    advance(steps // 2, 1, 1)
    after = place_now()
    turned = (after.rotation() @ before.rotation().inverse()).ToAngleAxis()
    moved = after.translation() - before.translation()
    turn = turned.angle() * turned.axis()
    return np.array([*moved[:2], turn[2]] if flat else [*moved, *turn]) / (steps // 2 * step)


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
            often = 1 if options.keys() == {"impratio"} else 2
            whole = {"cone": cone, **options}
            yield Setting("mujoco", f"{cone}, {words}", mujoco_run, whole, sample=often)
    for iterations in (10, 50):
        options = {"iterations": iterations, "step": 2e-3}
        yield Setting("pymunk", f"{iterations} iterations", pymunk_run, options, (2,))
    if find_spec("pydrake"):
        for contact in ("Sap", "Similar"):
            options = {"contact": contact, "step": 2e-3}
            yield Setting("drake", contact, drake_run, options, sample=6)
