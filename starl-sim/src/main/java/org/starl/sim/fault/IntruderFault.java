package org.starl.sim.fault;

import java.util.ArrayList;
import java.util.List;
import org.starl.id.RobotId;
import org.starl.input.Quantities;
import org.starl.sim.world.Body;

/**
 * A foreign body appears near a robot and blocks it; it disappears when the fault ends. No body
 * appears if there is no free place near the robot, or while the robot is off the floor.
 */
public sealed interface IntruderFault extends FaultEffect {

  /** Speed towards the robot, in mm/s; 0 for a parked body. */
  double speedMmPerS();

  @Override
  default Runnable begin(FaultContext onset) {
    List<Intruder> intruders = new ArrayList<>();
    for (RobotId robot : onset.whom()) {
      Body target = onset.ward().body(robot);
      String name = "intruder" + onset.number() + "." + intruders.size();
      if (target != null) {
        intruders.add(new Intruder(new RobotId(name), robot, speedMmPerS(), onset));
      }
    }
    return () -> intruders.forEach(Intruder::leave);
  }

  /** Drives into the robot repeatedly: {@code ram(bot1)}, {@code ram(bot1,300mm/s)}. */
  record Ram(RobotSelector who, double speedMmPerS) implements IntruderFault {

    static final double USUAL_MM_PER_S = 300;

    @Override
    public String name() {
      return "ram";
    }

    @Override
    public List<String> arguments() {
      return speedMmPerS == USUAL_MM_PER_S
          ? List.of(who.toString())
          : List.of(who.toString(), Quantities.speedText(speedMmPerS));
    }
  }

  /** Parks in front of the robot: {@code block(bot1,at=3s,for=10s)}. */
  record Block(RobotSelector who) implements IntruderFault {
    @Override
    public String name() {
      return "block";
    }

    @Override
    public List<String> arguments() {
      return List.of(who.toString());
    }

    @Override
    public double speedMmPerS() {
      return 0;
    }
  }
}
