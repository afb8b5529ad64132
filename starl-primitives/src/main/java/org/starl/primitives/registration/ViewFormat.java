package org.starl.primitives.registration;

import java.util.SortedMap;
import java.util.SortedSet;
import java.util.TreeMap;
import org.starl.comms.WireFormatException;
import org.starl.comms.WireReader;
import org.starl.comms.WireWriter;
import org.starl.id.ProcessId;
import org.starl.primitives.agreement.SynodCodec;
import org.starl.primitives.agreement.Value;
import org.starl.primitives.membership.Sections;
import org.starl.primitives.membership.View;

/** A view as a value of the Synod. The view's number is the decree's, and not in the bytes. */
final class ViewFormat implements SynodCodec.Format {

  private static final int FORMAT = 2;
  private static final int ROOM_FOR_GHOSTS = 100;

  @Override
  public void checkValue(Value value) {
    read(Long.MAX_VALUE, value);
  }

  @Override
  public void checkWish(Value wish) {
    Change.fromValue(wish);
  }

  /** Whether {@code view} fits into a value. */
  static boolean fits(View view) {
    return bytes(view) <= Value.MAX_BYTES;
  }

  /** Whether {@code view} fits, with room for a few ghosts. */
  static boolean fitsWithRoom(View view) {
    return bytes(view) <= Value.MAX_BYTES - ROOM_FOR_GHOSTS;
  }

  private static int bytes(View view) {
    return WireWriter.toBytes(out -> write(view, out)).length;
  }

  static Value toValue(View view) {
    return Value.write(out -> write(view, out));
  }

  private static void write(View view, WireWriter out) {
    out.u8(FORMAT);
    out.u16(view.admitted().size());
    view.admitted()
        .forEach((id, by) -> {
          out.process(id);
          out.i64(by);
        });
    out.u16(view.ghosts().size());
    view.ghosts()
        .forEach((id, ghost) -> {
          out.process(id);
          out.i64(ghost.admittedBy());
          Sections.write(ghost.sections(), out);
        });
  }

  /** Throws {@link WireFormatException} on what {@link #toValue} cannot have written. */
  static View read(long number, Value value) {
    return value.read("a view", in -> read(number, in));
  }

  private static View read(long number, WireReader in) {
    int format = in.u8();
    if (format != FORMAT) {
      throw new WireFormatException("view of format " + format);
    }
    int count = in.u16();
    SortedMap<ProcessId, Long> admitted = new TreeMap<>();
    for (int i = 0; i < count; i++) {
      ProcessId id = in.process();
      if (!isNext(admitted, id)) {
        throw new WireFormatException("view entry " + id + " twice, or out of order");
      }
      admitted.put(id, admittedBy(in, id, number));
    }
    count = in.u16();
    SortedMap<ProcessId, View.Ghost> ghosts = new TreeMap<>();
    for (int i = 0; i < count; i++) {
      ProcessId id = in.process();
      long by = admittedBy(in, id, number);
      SortedSet<String> sections = Sections.read(in);
      if (sections.isEmpty() || admitted.containsKey(id) || !isNext(ghosts, id)) {
        throw new WireFormatException("ghost " + id + " of " + sections);
      }
      ghosts.put(id, new View.Ghost(by, sections));
    }
    return new View(number, admitted, ghosts);
  }

  // In ascending order, so that equal views have equal bytes.
  private static boolean isNext(SortedMap<ProcessId, ?> read, ProcessId id) {
    return read.isEmpty() || read.lastKey().compareTo(id) < 0;
  }

  private static long admittedBy(WireReader in, ProcessId id, long number) {
    long by = in.i64();
    if (by < 1 || by > number) {
      throw new WireFormatException("view entry " + id + "@" + by);
    }
    return by;
  }
}
