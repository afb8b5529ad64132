package org.starl.robot.contract;

import java.util.ArrayList;
import java.util.List;
import org.starl.platform.Radio;
import org.starl.random.Rng;
import org.starl.sim.kernel.CarrierKind;
import org.starl.sim.net.Latency;
import org.starl.sim.net.Loss;
import org.starl.sim.net.SimNetwork;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceSink;

class SimRadioTest extends RadioContract {

  @Override
  protected Air newAir() {
    return new SimAir();
  }

  private static final class SimAir implements Air {

    private final List<SimGround> grounds = new ArrayList<>();
    private final List<Radio> radios = new ArrayList<>();
    private final SimNetwork network;

    SimAir() {
      SimGround first = new SimGround(CarrierKind.VIRTUAL);
      network = new SimNetwork(first.kernel(), new NoTrace(), new Rng(7));
      network.base(new Latency.Constant(3_000_000), Loss.NONE);
      for (int robot = 0; robot < ROBOTS; robot++) {
        SimGround ground = robot == 0 ? first : first.neighbour(id(robot).name());
        grounds.add(ground);
        radios.add(network.attach(id(robot), ground.strand()));
      }
    }

    @Override
    public Ground ground(int robot) {
      return grounds.get(robot);
    }

    @Override
    public Radio radio(int robot) {
      return radios.get(robot);
    }

    @Override
    public void closeRadio(int robot) {
      network.detach(id(robot));
    }

    @Override
    public void close() {
      grounds.get(0).close();
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
