package org.starl.apps.intersection.spec;

import static org.starl.time.Time.NS_PER_MS;
import static org.starl.time.Time.NS_PER_S;

import java.util.ArrayList;
import java.util.List;
import java.util.SortedMap;
import java.util.function.Supplier;
import org.starl.apps.intersection.logic.Crossing;
import org.starl.apps.intersection.logic.Lane;
import org.starl.geometry.Rectangle;
import org.starl.id.RobotId;
import org.starl.primitives.mutex.MutexBounds;
import org.starl.primitives.mutex.MutexSpec;
import org.starl.primitives.mutex.MutexTimes;
import org.starl.primitives.registration.RegistrationSpec;
import org.starl.spec.ExceptRobots;
import org.starl.spec.Monitor;

/**
 * All specifications of the intersection, with the bounds on progress. They are some times what is usual,
 * so that a crossing is seen that is ten times slower.
 *
 * @param deltaNs a message that is repeated until it is answered arrives within this time
 * @param cars at most so many at a time
 * @param turnNs the time from one car's entry to the next one's, if cars cross one after another
 * @param places number of ranks of places that a car claims on its arm; 0 if cars start in the arrival
 *     zone
 */
public record IntersectionSpec(long deltaNs, int cars, int places, long turnNs) {

  /** The turn of a car that keeps moving. */
  public static final long FLOWING_NS = 12 * NS_PER_S;

  /** The turn of a car that stops in each zone, and turns on the spot. */
  public static final long STOPPING_NS = 25 * NS_PER_S;

  // At most, for one car: to join the view and be granted its zones; to drive 3.5 m at the lowest
  // straight speed; to turn by a right angle three times at the lowest turning speed.
  private static final long NETWORK_NS = 15 * NS_PER_S;
  private static final long DRIVE_NS = 20 * NS_PER_S;
  private static final long TURNS_NS = 15 * NS_PER_S;
  // Once: until the last debris is cleared away.
  private static final long DEBRIS_NS = 30 * NS_PER_S;

  // Other cars that may go before a car at the head of its arm: three waiting, four crossing.
  private static final int TURNS_BEFORE = 7;

  // A car may have left: after so long, a car that waits asks for the latest view.
  private static final long REFRESH_NS = 2 * NS_PER_S;

  private static final long DAY_NS = 24 * 3600 * NS_PER_S;

  // So many losses in a row are not expected in all campaigns together.
  private static final double NEVER = 1e-13;

  public IntersectionSpec {
    if (deltaNs < 0 || cars < 0 || places < 0 || places >= Crossing.PLACES) {
      throw new IllegalArgumentException(
          "bounds of " + cars + " cars, " + places + " places, delta " + deltaNs + " ns");
    }
  }

  /**
   * Delta for messages that are repeated as the mutex does; at most about a day.
   *
   * @param longestDelayNs of a message that arrives
   * @param loss probability that a message is lost
   */
  public static long deltaNs(long longestDelayNs, double loss) {
    MutexTimes times = MutexTimes.DEFAULT;
    double roundTripFails = 1 - (1 - loss) * (1 - loss);
    double waitMs = times.resendMs();
    long deltaNs = longestDelayNs;
    for (double all = roundTripFails; all > NEVER && deltaNs < DAY_NS; all *= roundTripFails) {
      deltaNs += (long) (waitMs * NS_PER_MS) + REFRESH_NS;
      waitMs = Math.min(waitMs * times.backoff(), (double) times.maxResendMs());
    }
    return deltaNs;
  }

  /** From coming onto the floor to leaving it, if all cars cross one after another. */
  long trafficNs() {
    // On an open road new cars arrive, but they do not go before a car at the head of its arm.
    int turns = places == 0 ? cars : (places + 1) * (TURNS_BEFORE + 1);
    return turns * turnNs + (places + 2) * (NETWORK_NS + 2 * deltaNs) + DEBRIS_NS;
  }

  /** After the last arrival all cars have left within this time. */
  public long drainNs() {
    return trafficNs() + NETWORK_NS;
  }

  /**
   * Creates the monitors of one run each, of the intersection {@code xid}.
   *
   * @param stray cars that leave their way after a bump, or at random: they enter zones of others,
   *     and may hold theirs for long
   */
  public List<Supplier<? extends Monitor>> monitors(String xid, List<RobotId> stray) {
    SortedMap<String, Rectangle> regions = Crossing.regions(places);
    int participants = Math.max(1, cars);
    MutexBounds zones = MutexBounds.of(participants, DRIVE_NS + TURNS_NS, deltaNs);
    List<Supplier<? extends Monitor>> monitors = new ArrayList<>();
    monitors.add(() ->
        new ExceptRobots(
            new TrafficSafety(regions), stray, TrafficSafety.OF_BODIES, "leave their way"));
    monitors.add(() -> new ListCrit(xid));
    monitors.add(() -> {
      TrafficProgress progress = new TrafficProgress(trafficNs(), stray);
      return new ExceptRobots(progress, stray, progress.lemmas(), "leave their way");
    });
    boolean hasSequences = turnNs == FLOWING_NS;
    monitors.add(() -> {
      MutexSpec mutex = new MutexSpec(zones);
      return (hasSequences ? mutex.withSequences() : mutex).only(xid);
    });
    monitors.add(RegistrationSpec::new);
    // A car holds its place while it waits for its zones.
    MutexBounds queue = MutexBounds.of(participants, trafficNs(), deltaNs);
    if (places > 0) {
      monitors.add(() -> new MutexSpec(queue).withSequences().only(Lane.instance(xid)));
    }
    return monitors;
  }
}
