package org.starl.primitives.registration;

import java.util.ArrayList;
import java.util.Arrays;
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
 * What one robot wants different in the next view.
 *
 * @param join who wants to be in, or null; an id that has never stood in any view
 * @param leave who wants to be out; ids of the robot's own that will never request anything again
 * @param confine who is to be given up
 */
record Change(@Nullable ProcessId join, List<ProcessId> leave, List<Confinement> confine) {

  static final Change NONE = new Change(null, List.of(), List.of());

  /** A wish with more confinements leaves the rest for later: it is a hint. */
  private static final int MAX_WISH_BYTES = 350;

  Change {
    leave = List.copyOf(leave);
    confine = List.copyOf(confine);
  }

  /** Whether {@code view} already is as wanted. */
  boolean isVoidIn(View view) {
    boolean joins = join != null && !view.contains(join);
    return !joins
        && leave.stream().noneMatch(view::mentions)
        && confine.stream().noneMatch(each -> each.changes(view));
  }

  /** This as a wish, which others may fulfil: as much of it as fits. */
  Value toValue() {
    byte[] buffer = new byte[Value.MAX_BYTES];
    WireWriter out = new WireWriter(buffer);
    out.bool(join != null);
    if (join != null) {
      out.process(join);
    }
    out.u8(leave.size());
    for (ProcessId id : leave) {
      out.process(id);
    }
    List<Confinement> fitting = new ArrayList<>();
    int bytes = out.length() + 1;
    for (Confinement each : confine) {
      bytes += each.bytes();
      if (bytes <= MAX_WISH_BYTES) {
        fitting.add(each);
      }
    }
    out.u8(fitting.size());
    fitting.forEach(each -> each.write(out));
    return Value.of(Arrays.copyOf(buffer, out.length()));
  }

  /** Throws {@link WireFormatException} on what {@link #toValue} cannot have written. */
  static Change fromValue(Value value) {
    WireReader in = new WireReader(value.bytes());
    ProcessId join = in.bool() ? in.process() : null;
    int count = in.u8();
    List<ProcessId> leave = new ArrayList<>(count);
    for (int i = 0; i < count; i++) {
      leave.add(in.process());
    }
    count = in.u8();
    List<Confinement> confine = new ArrayList<>(count);
    for (int i = 0; i < count; i++) {
      confine.add(Confinement.read(in));
    }
    if (in.remaining() > 0) {
      throw new WireFormatException(in.remaining() + " bytes after a change");
    }
    return new Change(join, leave, confine);
  }
}
