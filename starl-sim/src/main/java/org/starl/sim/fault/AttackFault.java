package org.starl.sim.fault;

import java.util.List;
import org.starl.input.Quantities;

/**
 * An attacker without the deployment's key. It records all datagrams and sends its own datagrams to
 * robots. Robots without a key accept them; {@code sealed=yes} gives the robots a key.
 */
public sealed interface AttackFault extends FaultEffect {

  /** Mean time between two attacks on one robot, in ns; the times are exponential. */
  long meanNs();

  /** The next datagram to send; {@code length} is 0 before the first recording. */
  byte[] next(Eavesdropper heard);

  @Override
  default List<String> arguments() {
    return List.of(who().toString(), Quantities.durationText(meanNs()));
  }

  @Override
  default Runnable begin(FaultContext onset) {
    return new Attack(this, onset)::end;
  }

  /** Sends changed recordings: other bytes, another sender, higher numbers, longer or shorter. */
  record Forge(RobotSelector who, long meanNs) implements AttackFault {
    @Override
    public String name() {
      return "forge";
    }

    @Override
    public byte[] next(Eavesdropper heard) {
      return heard.changed();
    }
  }

  /** Sends unchanged recordings of any age. */
  record Replay(RobotSelector who, long meanNs) implements AttackFault {
    @Override
    public String name() {
      return "replay";
    }

    @Override
    public byte[] next(Eavesdropper heard) {
      return heard.recorded();
    }
  }

  /** Sends random bytes. */
  record Flood(RobotSelector who, long meanNs) implements AttackFault {
    @Override
    public String name() {
      return "flood";
    }

    @Override
    public byte[] next(Eavesdropper heard) {
      return heard.noise();
    }
  }
}
