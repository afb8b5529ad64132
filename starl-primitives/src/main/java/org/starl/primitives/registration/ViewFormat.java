package org.starl.primitives.registration;

import java.util.Arrays;
import java.util.Map;
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

/** The bytes of a view, as they are agreed on. Its number is the decree's, and not among them. */
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

  /** Whether {@code view} is short enough to be agreed on. */
  static boolean fits(View view) {
    return bytes(view) <= Value.MAX_BYTES;
  }

  /** Whether some of those in {@code view} could still become ghosts. */
  static boolean fitsWithRoom(View view) {
    return bytes(view) <= Value.MAX_BYTES - ROOM_FOR_GHOSTS;
  }

  private static long bytes(View view) {
    long bytes = 1 + 2 * Short.BYTES;
    for (ProcessId id : view.mentioned()) {
      bytes += 1 + id.robot().name().length() + Long.BYTES + Long.BYTES;
    }
    for (View.Ghost ghost : view.ghosts().values()) {
      bytes += Sections.bytes(ghost.sections());
    }
    return bytes;
  }

  static Value toValue(View view) {
    byte[] buffer = new byte[Value.MAX_BYTES];
    WireWriter out = new WireWriter(buffer);
    out.u8(FORMAT);
    out.u16(view.admitted().size());
    for (Map.Entry<ProcessId, Long> entry : view.admitted().entrySet()) {
      out.process(entry.getKey());
      out.i64(entry.getValue());
    }
    out.u16(view.ghosts().size());
    for (Map.Entry<ProcessId, View.Ghost> entry : view.ghosts().entrySet()) {
      out.process(entry.getKey());
      out.i64(entry.getValue().admittedBy());
      Sections.write(entry.getValue().sections(), out);
    }
    return Value.of(Arrays.copyOf(buffer, out.length()));
  }

  /** Throws {@link WireFormatException} on what {@link #toValue} cannot have written. */
  static View read(long number, Value value) {
    WireReader in = new WireReader(value.bytes());
    int format = in.u8();
    if (format != FORMAT) {
      throw new WireFormatException("view of format " + format);
    }
    int count = in.u16();
    SortedMap<ProcessId, Long> admitted = new TreeMap<>();
    for (int i = 0; i < count; i++) {
      ProcessId id = in.process();
      if (!isNext(admitted, id)) {
        throw new WireFormatException("view entry " + id + " twice, or not in its place");
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
    if (in.remaining() > 0) {
      throw new WireFormatException(in.remaining() + " bytes after a view");
    }
    return new View(number, admitted, ghosts);
  }

  // In ascending order: a view has one spelling.
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
