package org.starl.sim.fault;

import java.util.List;
import org.starl.input.Quantities;

/**
 * Somebody without the deployment's key hears all that is sent, and sends to robots what no robot
 * sent. Robots without a key take it for each other's; {@code sealed=yes} gives them one.
 */
public sealed interface AttackHarm extends Harm {

  /** The mean time between two attacks on one robot, in ns; each time is exponential. */
  long meanNs();

  /** What is sent next, or nothing ({@code length} 0) while there is nothing to go by. */
  byte[] next(Eavesdropper heard);

  @Override
  default List<String> arguments() {
    return List.of(who().toString(), Quantities.durationText(meanNs()));
  }

  @Override
  default Runnable begin(Onset onset) {
    return new Attack(this, onset)::end;
  }

  /** Sends changed recordings: other bytes, another sender, higher numbers, more or less of it. */
  record Forge(Who who, long meanNs) implements AttackHarm {
    @Override
    public String name() {
      return "forge";
    }

    @Override
    public byte[] next(Eavesdropper heard) {
      return heard.changed();
    }
  }

  /** Sends recordings as they are, however old. */
  record Replay(Who who, long meanNs) implements AttackHarm {
    @Override
    public String name() {
      return "replay";
    }

    @Override
    public byte[] next(Eavesdropper heard) {
      return heard.recorded();
    }
  }

  /** Sends bytes without sense. */
  record Flood(Who who, long meanNs) implements AttackHarm {
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
