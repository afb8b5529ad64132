package org.starl.sim;

import java.util.List;
import org.jspecify.annotations.Nullable;
import org.starl.GlobalVarHolder;
import org.starl.RobotRunner;
import org.starl.motion.MotionFlag;
import org.starl.platform.Platform;
import org.starl.random.Rng;
import org.starl.sim.kernel.Kernel;
import org.starl.sim.kernel.SimStrand;
import org.starl.sim.world.Body;
import org.starl.sim.world.SimChassis;
import org.starl.sim.world.SimPositioning;
import org.starl.sim.world.SimStable;
import org.starl.sim.world.World;

/** One robot of a run: its program on a simulated platform, and its body while on the floor. */
final class SimRobot {

  private final RobotSpec spec;
  private final SimStrand strand;
  private final SimChassis chassis;
  private final SimPositioning positioning;
  private final RobotRunner runner;
  private final Engine engine;
  private boolean finished;
  private @Nullable Body body;

  /**
   * @param stable what survives of the robot's earlier incarnations
   * @param index how many robots were brought up before it
   */
  SimRobot(RobotSpec spec, Engine engine, SimStable stable, int index) {
    this.spec = spec;
    this.engine = engine;
    SimSettings settings = engine.settings();
    Kernel kernel = engine.kernel();
    Rng rng = engine.behaviourRng(spec.id());
    strand = kernel.strand(spec.id().name());
    chassis = new SimChassis(strand, rng.fork("chassis"), settings.speedError());
    positioning = positioning(settings, kernel, rng.fork("positioning"));
    stable.restart(strand);
    Platform platform =
        new Platform(
            spec.id(),
            engine.deployment(),
            kernel,
            strand,
            strand,
            engine.network().attach(spec.id(), strand::schedule),
            positioning,
            chassis,
            stable,
            rng::fork,
            engine.watchers().logOf(spec.id()),
            engine.watchers(),
            engine.knownObstacles(),
            settings.motionParameters(index));
    runner = new RobotRunner(platform, spec.app(), this::appEnded);
  }

  private SimPositioning positioning(SimSettings settings, Kernel kernel, Rng rng) {
    long periodNs = settings.positionPeriodNs();
    long phaseNs =
        settings.get(Setting.POSITION_IN_PHASE) ? 0 : SimPositioning.drawnPhaseNs(rng, periodNs);
    return new SimPositioning(
        kernel, kernel, strand, rng, settings.positionNoise(), periodNs, phaseNs);
  }

  RobotSpec spec() {
    return spec;
  }

  void start() {
    runner.start();
  }

  /** Ends the program: nothing of it runs any more. */
  void end() {
    strand.close();
  }

  boolean isFinished() {
    return finished;
  }

  MotionFlag motionflag() {
    GlobalVarHolder gvh = runner.gvh();
    return gvh == null ? MotionFlag.IDLE : gvh.plat.moat.motionflag().get();
  }

  boolean isOnFloor() {
    return body != null;
  }

  Body body() {
    if (body == null) {
      throw new IllegalStateException(spec.id() + " is not on the floor");
    }
    return body;
  }

  void putOnFloor(Body newBody) {
    body = newBody;
    chassis.mount(newBody);
    positioning.mount(newBody);
  }

  void takeOffFloor(World world) {
    if (body != null) {
      chassis.unmount();
      positioning.unmount();
      world.remove(body);
      body = null;
    }
  }

  private void appEnded() {
    List<Object> results = runner.results();
    if (results == null) {
      throw new IllegalStateException(spec.id() + " ended without results");
    }
    finished = true;
    engine.appEnded(spec.id(), results);
  }
}
