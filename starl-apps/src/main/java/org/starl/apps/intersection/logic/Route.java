package org.starl.apps.intersection.logic;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.starl.shape.Shape;
import org.starl.shape.Shapes;

/**
 * One of the twelve routes through the intersection: from arrival zone {@code from}0 through {@code
 * from} and its successors in the ring.
 */
public record Route(Zone from, Turn turn) {

  /**
   * The routes of Figure 7 (paper, section 5.3): robot 0 in C0 turns right, robot 1 in D0 goes
   * straight, robot 2 in B0 turns left, robot 3 in A0 turns right.
   */
  public static final List<Route> FIGURE7 =
      List.of(
          new Route(Zone.C, Turn.RIGHT),
          new Route(Zone.D, Turn.STRAIGHT),
          new Route(Zone.B, Turn.LEFT),
          new Route(Zone.A, Turn.RIGHT));

  /** All twelve routes. */
  public static List<Route> all() {
    return Arrays.stream(Zone.values())
        .flatMap(from -> Arrays.stream(Turn.values()).map(turn -> new Route(from, turn)))
        .collect(Collectors.toList());
  }

  /** The shape of routes. */
  public static final Shape<Route> SHAPE =
      Shapes.of(
          Route.class,
          Shapes.part("from", Shapes.constant(Zone.class), Route::from),
          Shapes.part("turn", Shapes.constant(Turn.class), Route::turn),
          Route::new);

  /** The route that is written {@code text}, as by {@link #toString}. */
  public static Optional<Route> parse(String text) {
    return all().stream().filter(route -> route.toString().equals(text)).findFirst();
  }

  /** The critical zones in the order in which they are crossed. */
  public List<Zone> zones() {
    return Stream.iterate(from, Zone::next).limit(turn.zones()).collect(Collectors.toList());
  }

  public Zone lastZone() {
    return zones().get(turn.zones() - 1);
  }

  /** The arrival zone: {@code A0}. */
  public String arrival() {
    return from + "0";
  }

  /** The departure zone: {@code D1}. */
  public String departure() {
    return lastZone() + "1";
  }

  /** The paper's notation: {@code A0 A C D D1}. */
  @Override
  public String toString() {
    String zones = zones().stream().map(Zone::name).collect(Collectors.joining(" "));
    return arrival() + " " + zones + " " + departure();
  }
}
