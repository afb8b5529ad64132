package org.starl.session;

import java.util.Map;
import java.util.TreeMap;
import java.util.function.Function;
import java.util.function.Supplier;
import java.util.function.ToIntFunction;
import org.jspecify.annotations.Nullable;
import org.starl.id.RobotId;

/**
 * Sessions of a robot that knows how often each other robot has started, without an exchange of
 * nonces: for simulated robots. Strand only.
 */
public final class KnownStarts implements Sessions {

  private final Function<RobotId, PairKey> keys;
  private final RobotId self;
  private final int start;
  private final ToIntFunction<RobotId> startOf;
  private final Supplier<? extends Iterable<RobotId>> robots;
  private final Session.@Nullable Watch watch;
  private final Map<RobotId, Known> known = new TreeMap<>();

  private record Known(int start, Session session) {}

  /**
   * @param keys the key of this robot with another
   * @param start number of this robot's start: above those of its earlier starts
   * @param startOf number of another robot's latest start; 0 if there is none
   * @param robots all robots now, in order
   * @param watch of all sessions; null for none
   */
  public KnownStarts(
      Function<RobotId, PairKey> keys,
      RobotId self,
      int start,
      ToIntFunction<RobotId> startOf,
      Supplier<? extends Iterable<RobotId>> robots,
      Session.@Nullable Watch watch) {
    this.keys = keys;
    this.self = self;
    this.start = start;
    this.startOf = startOf;
    this.robots = robots;
    this.watch = watch;
  }

  @Override
  public @Nullable Session with(RobotId peer) {
    int now = startOf.applyAsInt(peer);
    if (now == 0) {
      return null;
    }
    Known last = known.get(peer);
    if (last == null || last.start != now) {
      Session session =
          new Session(keys.apply(peer), self, number(start), peer, number(now), watch);
      last = new Known(now, session);
      known.put(peer, last);
    }
    return last.session;
  }

  @Override
  public Iterable<RobotId> peers() {
    return robots.get();
  }

  private static Start number(int start) {
    return new Start(0, start, new Nonce(0, start));
  }
}
