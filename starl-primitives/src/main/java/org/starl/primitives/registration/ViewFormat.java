package org.starl.primitives.registration;

import java.util.Arrays;
import java.util.Map;
import java.util.SortedMap;
import java.util.TreeMap;
import org.starl.ProcessId;
import org.starl.comms.WireFormatException;
import org.starl.comms.WireReader;
import org.starl.comms.WireWriter;
import org.starl.primitives.agreement.SynodCodec;
import org.starl.primitives.agreement.Value;
import org.starl.primitives.membership.View;

/** The bytes of a view, as they are agreed on. Its number is the decree's, and not among them. */
final class ViewFormat implements SynodCodec.Format {

  private static final int FORMAT = 1;

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
    long bytes = 1 + Short.BYTES;
    for (ProcessId id : view.admitted().keySet()) {
      bytes += 1 + id.robot().name().length() + Long.BYTES + Long.BYTES;
    }
    return bytes <= Value.MAX_BYTES;
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
      long by = in.i64();
      if (by < 1 || by > number || admitted.put(id, by) != null) {
        throw new WireFormatException("view entry " + id + "@" + by);
      }
    }
    if (in.remaining() > 0) {
      throw new WireFormatException(in.remaining() + " bytes after a view");
    }
    return new View(number, admitted);
  }
}
