package org.starl.primitives.registration;

import java.util.SortedMap;
import org.starl.id.ProcessId;
import org.starl.primitives.agreement.SynodCodec;
import org.starl.primitives.agreement.Value;
import org.starl.primitives.membership.View;
import org.starl.shape.WireFormatException;
import org.starl.shape.WireReader;
import org.starl.shape.WireWriter;

/** A view as a value of the Synod. The view's number is the decree's, and not in the bytes. */
final class ViewFormat implements SynodCodec.Format {

  private static final int FORMAT = 2;
  private static final int ROOM_FOR_GHOSTS = 100;

  @Override
  public void checkValue(long number, Value value) {
    read(number, value);
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
    View.ADMITTED.write(view.admitted(), out);
    View.GHOSTS.write(view.ghosts(), out);
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
    SortedMap<ProcessId, Long> admitted = View.ADMITTED.read(in);
    SortedMap<ProcessId, View.Ghost> ghosts = View.GHOSTS.read(in);
    try {
      return new View(number, admitted, ghosts);
    } catch (IllegalArgumentException refused) {
      throw new WireFormatException(String.valueOf(refused.getMessage()));
    }
  }
}
