package org.starl.primitives.paths;

import static org.starl.shape.Shapes.part;

import java.util.ArrayList;
import java.util.List;
import org.starl.shape.Shape;
import org.starl.shape.Shapes;

/**
 * The tubes of one robot.
 *
 * @param version grows with every change, also over a restart
 * @param held the tubes that it may occupy
 * @param wanted the tube that it requests in addition, or none
 */
record Holding(long version, List<Tube> held, List<Tube> wanted) {

  static final Holding NONE = new Holding(0, List.of(), List.of());

  /** The largest number of held tubes. */
  static final int MAX_TUBES = 2;

  /** The shape of versions. */
  static final Shape<Long> VERSION = Shapes.atLeast(0, "version");

  /** Its shape, in messages and on stable storage. */
  static final Shape<Holding> SHAPE =
      Shapes.of(
          Holding.class,
          part("version", VERSION, Holding::version),
          part("held", Shapes.list(Tube.SHAPE, MAX_TUBES), Holding::held),
          part("wanted", Shapes.list(Tube.SHAPE, 1), Holding::wanted),
          Holding::new);

  Holding {
    held = List.copyOf(held);
    wanted = List.copyOf(wanted);
    if (version < 0 || held.size() > MAX_TUBES || wanted.size() > 1) {
      throw new IllegalArgumentException(
          "version " + version + ", " + held.size() + " tubes held, " + wanted.size() + " wanted");
    }
  }

  List<Tube> all() {
    List<Tube> all = new ArrayList<>(held);
    all.addAll(wanted);
    return all;
  }

  /** The state after a restart: without wanted tubes, and newer than all earlier versions. */
  Holding inBoot(int boot) {
    return new Holding((long) boot << Integer.SIZE, held, List.of());
  }

  Holding withoutWanted() {
    return new Holding(version, held, List.of());
  }
}
