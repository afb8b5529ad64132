package org.starl.launch;

import java.io.FileDescriptor;
import java.io.FileOutputStream;
import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import org.starl.GlobalVarHolder;
import org.starl.LogicThread;
import org.starl.id.RobotId;
import org.starl.primitives.mutex.M_Mutex;
import org.starl.sim.Simulation;
import org.starl.sim.SimulationPlan;

/** One of two robots as a process, which take two mutexes in different order. */
final class DeadlockMain {

  private DeadlockMain() {}

  public static void main(String[] args) throws IOException {
    RobotProcess.run(
        DeadlockMain::plan,
        new RobotId(args[0]),
        Path.of(args[1]),
        Integer.parseInt(args[2]),
        System.in,
        new FileOutputStream(FileDescriptor.out));
  }

  static SimulationPlan plan() {
    return Simulation.builder().robots(2, Taker::new).seed(1).build().plan();
  }

  private static final class Taker extends LogicThread {
    private final M_Mutex first;
    private final M_Mutex second;

    Taker(GlobalVarHolder gvh) {
      super(gvh);
      M_Mutex left = new M_Mutex(gvh, "left", gvh.id.participants());
      M_Mutex right = new M_Mutex(gvh, "right", gvh.id.participants());
      boolean isFirst = gvh.id.name().name().equals("bot0");
      first = isFirst ? left : right;
      second = isFirst ? right : left;
    }

    @Override
    public List<Object> callStarL() {
      first.do_mutex(List.of("S"));
      await(first::od_mutex);
      sleep(500);
      second.do_mutex(List.of("S"));
      await("both sections", second::od_mutex);
      return returnResults();
    }
  }
}
