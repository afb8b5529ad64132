package org.starl.primitives.registration;

import static org.starl.shape.Shapes.PROCESS;
import static org.starl.shape.Shapes.part;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.starl.id.ProcessId;
import org.starl.primitives.agreement.Value;
import org.starl.primitives.membership.Confinement;
import org.starl.primitives.membership.View;
import org.starl.shape.Shape;
import org.starl.shape.Shapes;
import org.starl.shape.WireFormatException;
import org.starl.shape.WireWriter;

/**
 * The changes that one robot wants in the next view.
 *
 * @param join the id to admit, or null; it was in no view before
 * @param leave ids of this robot to remove; they will never request anything again
 * @param confine the ids to give up, as crashed
 */
record Change(@Nullable ProcessId join, List<ProcessId> leave, List<Confinement> confine) {

  static final Change NONE = new Change(null, List.of(), List.of());

  /** The longest wish. More confinements wait for a later view: a wish is a hint. */
  private static final int MAX_WISH_BYTES = 350;

  Change {
    leave = List.copyOf(leave);
    confine = List.copyOf(confine);
  }

  /** Whether it changes nothing in {@code view}. */
  boolean isVoidIn(View view) {
    boolean joins = join != null && !view.contains(join);
    return !joins
        && leave.stream().noneMatch(view::mentions)
        && confine.stream().noneMatch(each -> each.changes(view));
  }

  /** The shape of wishes. */
  private static final Shape<Change> SHAPE =
      Shapes.of(
          Change.class,
          part("join", Shapes.optional(PROCESS), change -> Optional.ofNullable(change.join())),
          part("leave", Shapes.list(PROCESS, 0xFF), Change::leave),
          part("confine", Shapes.list(Confinement.SHAPE, 0xFF), Change::confine),
          (join, leave, confine) -> new Change(join.orElse(null), leave, confine));

  /** As a wish, which other robots may fulfil: as much as fits. */
  Value toValue() {
    List<Confinement> fitting = new ArrayList<>();
    int bytes = bytes(SHAPE, new Change(join, leave, fitting));
    for (Confinement each : confine) {
      bytes += bytes(Confinement.SHAPE, each);
      if (bytes <= MAX_WISH_BYTES) {
        fitting.add(each);
      }
    }
    Change wish = new Change(join, leave, fitting);
    return Value.write(out -> SHAPE.write(wish, out));
  }

  private static <T> int bytes(Shape<T> shape, T value) {
    return WireWriter.toBytes(out -> shape.write(value, out)).length;
  }

  /** Throws {@link WireFormatException} on what {@link #toValue} cannot have written. */
  static Change fromValue(Value value) {
    return value.read("a change", SHAPE::read);
  }
}
