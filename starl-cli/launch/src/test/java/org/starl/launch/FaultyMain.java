package org.starl.launch;

import java.io.FileDescriptor;
import java.io.FileOutputStream;
import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import org.starl.GlobalVarHolder;
import org.starl.LogicThread;
import org.starl.id.RobotId;
import org.starl.sim.Simulation;
import org.starl.sim.SimulationPlan;

/**
 * One of two robots as a process, of which the second has a bug; arguments as the launcher appends
 * them.
 */
final class FaultyMain {

  private FaultyMain() {}

  public static void main(String[] args) throws IOException {
    RobotProcess.run(
        FaultyMain::plan,
        new RobotId(args[0]),
        Path.of(args[1]),
        Integer.parseInt(args[2]),
        System.in,
        new FileOutputStream(FileDescriptor.out));
  }

  static SimulationPlan plan() {
    return Simulation.builder().robots(2, Faulty::new).seed(1).build().plan();
  }

  private static final class Faulty extends LogicThread {
    Faulty(GlobalVarHolder gvh) {
      super(gvh);
    }

    @Override
    public List<Object> callStarL() {
      if (gvh.id.name().name().equals("bot1")) {
        throw new IllegalStateException("the bug");
      }
      sleep(1_000_000);
      return List.of();
    }
  }
}
