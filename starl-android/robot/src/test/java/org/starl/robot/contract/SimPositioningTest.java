package org.starl.robot.contract;

import java.util.ArrayList;
import java.util.List;
import java.util.SortedMap;
import java.util.TreeMap;
import org.starl.body.WheelCommand;
import org.starl.geometry.Fix;
import org.starl.geometry.Obstacles;
import org.starl.geometry.Pose;
import org.starl.id.RobotId;
import org.starl.platform.Positioning;
import org.starl.random.Rng;
import org.starl.sim.kernel.CarrierKind;
import org.starl.sim.world.Body;
import org.starl.sim.world.MeasuredRobots;
import org.starl.sim.world.PositionNoise;
import org.starl.sim.world.SimPositioning;
import org.starl.sim.world.World;
import org.starl.sim.world.WorldLimits;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceSink;

class SimPositioningTest extends PositioningContract {

  private static final long PERIOD_NS = 75_000_000;

  @Override
  protected Course newCourse() {
    return new SimCourse();
  }

  private static final class SimCourse implements Course {

    private final SimGround ground = new SimGround(CarrierKind.VIRTUAL);
    private final MeasuredRobots measured = new MeasuredRobots();
    private final List<SimPositioning> positionings = new ArrayList<>();

    SimCourse() {
      World world =
          new World(
              ground.kernel(),
              ground.kernel()::timer,
              new NoTrace(),
              WorldLimits.CREATE,
              Obstacles.NONE);
      for (int robot = 0; robot < 2; robot++) {
        Body body = world.add(new RobotId("robot" + robot), new Pose(0, 1000 * robot, 0), 165);
        body.drive(new WheelCommand(MM_PER_S, 0));
        SimPositioning positioning =
            new SimPositioning(
                new RobotId("robot" + robot),
                measured,
                ground.clock(),
                ground.clock(),
                ground.timers(),
                new Rng(robot),
                new PositionNoise(20, 0.05),
                PERIOD_NS,
                0);
        positioning.mount(body);
        positionings.add(positioning);
      }
    }

    @Override
    public Ground ground() {
      return ground;
    }

    @Override
    public Positioning positioning(int robot) {
      return positionings.get(robot);
    }

    @Override
    public SortedMap<String, Fix> newest() {
      SortedMap<String, Fix> named = new TreeMap<>();
      positionings.get(0).newest().forEach((robot, fix) -> named.put(robot.name(), fix));
      return named;
    }

    @Override
    public void see(int robot, boolean isSeen) {
      positionings.get(robot).turn(isSeen);
    }

    @Override
    public void close() {
      ground.close();
    }
  }

  private static final class NoTrace implements TraceSink {

    @Override
    public boolean isOn() {
      return false;
    }

    @Override
    public void record(TraceEvent event) {
      throw new IllegalStateException("nobody listens");
    }
  }
}
