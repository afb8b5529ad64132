package org.starl.primitives.registration;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.SortedMap;
import java.util.TreeMap;
import org.jspecify.annotations.Nullable;
import org.starl.ProcessId;
import org.starl.comms.WireFormatException;
import org.starl.comms.WireReader;
import org.starl.comms.WireWriter;
import org.starl.primitives.agreement.Value;
import org.starl.primitives.membership.View;

/**
 * What one robot wants different in the next view: its own ids only.
 *
 * @param join who wants to be in, or null; an id that has never stood in any view
 * @param leave who wants to be out; ids that will never request anything again
 */
record Change(@Nullable ProcessId join, List<ProcessId> leave) {

  static final Change NONE = new Change(null, List.of());

  Change {
    leave = List.copyOf(leave);
  }

  /** Whether {@code view} already is as wanted. */
  boolean isVoidIn(View view) {
    boolean joins = join != null && !view.contains(join);
    for (ProcessId id : leave) {
      if (view.contains(id)) {
        return false;
      }
    }
    return !joins;
  }

  /** The model's {@code Change}: the view after {@code decided}, so changed. */
  View apply(View decided) {
    return applyTo(decided.number() + 1, decided.admitted());
  }

  /** Further changes of a view that is not decided yet: {@code number} stays. */
  View alsoApply(View proposed) {
    return applyTo(proposed.number(), proposed.admitted());
  }

  private View applyTo(long number, SortedMap<ProcessId, Long> before) {
    SortedMap<ProcessId, Long> after = new TreeMap<>(before);
    for (ProcessId id : leave) {
      after.remove(id);
    }
    if (join != null) {
      after.putIfAbsent(join, number);
    }
    return new View(number, after);
  }

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
    if (in.remaining() > 0) {
      throw new WireFormatException(in.remaining() + " bytes after a change");
    }
    return new Change(join, leave);
  }
}
