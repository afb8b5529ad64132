package org.starl.apps.fleet.logic;

import static org.starl.shape.Shapes.part;

import java.util.List;
import org.starl.shape.RecordShape;
import org.starl.shape.Shapes;
import org.starl.time.Time;

/**
 * A load to fetch at one station and to put down at another.
 *
 * @param atMs when it is asked for, in ms from the start of the fleet
 * @param pick number of the vertex where it lies
 * @param drop number of the vertex where it is wanted
 */
public record Delivery(long atMs, int pick, int drop) {

  static final RecordShape<Delivery> SHAPE =
      Shapes.of(
          Delivery.class,
          part("atMs", Shapes.LONG, Delivery::atMs),
          part("pick", Shapes.INT, Delivery::pick),
          part("drop", Shapes.INT, Delivery::drop),
          Delivery::new);

  /** Where it lies, and where it is wanted. */
  List<Integer> stops() {
    return List.of(pick, drop);
  }

  /** {@link #atMs} in ns. */
  public long atNs() {
    return atMs * Time.NS_PER_MS;
  }
}
