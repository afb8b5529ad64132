package org.starl.apps.intersection;

import java.util.Optional;
import java.util.function.Function;
import java.util.function.Supplier;
import org.jspecify.annotations.Nullable;
import org.starl.apps.intersection.logic.Crossing;
import org.starl.apps.intersection.logic.Trip;
import org.starl.id.RobotId;

/**
 * Where the cars of an open road are bound for, for pictures: drawn again from the seed that their
 * arrivals are drawn from, so that a run in a file tells it too.
 *
 * @param arrivals the same ones at each call
 * @param prefix of the cars' names
 */
record TripBook(Crossing crossing, Supplier<Arrivals> arrivals, String prefix)
    implements Function<RobotId, Optional<Trip>> {

  @Override
  public Optional<Trip> apply(RobotId robot) {
    if (!robot.name().startsWith(prefix)) {
      return Optional.empty();
    }
    String number = robot.name().substring(prefix.length());
    if (!number.matches("\\d{1,9}")) {
      return Optional.empty();
    }
    Arrivals again = arrivals.get();
    @Nullable Arrival next = again.poll(Long.MAX_VALUE);
    for (int i = Integer.parseInt(number); i > 0 && next != null; i--) {
      next = again.poll(Long.MAX_VALUE);
    }
    return Optional.ofNullable(next).map(arrival -> crossing.tripFromEdge(arrival.route()));
  }
}
