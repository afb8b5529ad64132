package org.starl.primitives.registration;

import java.util.ArrayList;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.starl.comms.WireFormatException;
import org.starl.comms.WireReader;
import org.starl.comms.WireWriter;
import org.starl.id.ProcessId;
import org.starl.primitives.agreement.Value;
import org.starl.primitives.membership.Confinement;
import org.starl.primitives.membership.View;

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

  /** As a wish, which other robots may fulfil: as much as fits. */
  Value toValue() {
    return Value.write(out -> {
      out.bool(join != null);
      if (join != null) {
        out.process(join);
      }
      out.u8(leave.size());
      leave.forEach(out::process);
      List<Confinement> fitting = new ArrayList<>();
      int bytes = out.length() + 1;
      for (Confinement each : confine) {
        bytes += WireWriter.toBytes(each::write).length;
        if (bytes <= MAX_WISH_BYTES) {
          fitting.add(each);
        }
      }
      out.u8(fitting.size());
      fitting.forEach(each -> each.write(out));
    });
  }

  /** Throws {@link WireFormatException} on what {@link #toValue} cannot have written. */
  static Change fromValue(Value value) {
    return value.read("a change", Change::read);
  }

  private static Change read(WireReader in) {
    ProcessId join = in.bool() ? in.process() : null;
    List<ProcessId> leave = in.list(in.u8(), WireReader::process);
    return new Change(join, leave, in.list(in.u8(), Confinement::read));
  }
}
