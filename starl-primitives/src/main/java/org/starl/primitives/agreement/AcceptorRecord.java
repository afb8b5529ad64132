package org.starl.primitives.agreement;

import java.util.Collections;
import java.util.SortedMap;
import java.util.TreeMap;
import org.jspecify.annotations.Nullable;
import org.starl.comms.WireFormatException;
import org.starl.comms.WireReader;
import org.starl.comms.WireWriter;
import org.starl.primitives.agreement.SynodMessage.Decided;
import org.starl.primitives.agreement.SynodMessage.Vote;

/**
 * The memory of an acceptor that must survive a restart.
 *
 * @param decided the latest decree it knows, or null
 * @param slots its promise and vote for each later number that it was asked about
 */
record AcceptorRecord(@Nullable Decided decided, SortedMap<Long, Slot> slots) {

  static final AcceptorRecord NEW = new AcceptorRecord(null, new TreeMap<>());

  private static final int FORMAT = 1;

  AcceptorRecord {
    slots = Collections.unmodifiableSortedMap(new TreeMap<>(slots));
  }

  /** The promise and the vote for one number. */
  record Slot(Ballot promised, @Nullable Vote vote) {}

  byte[] toBytes() {
    return WireWriter.toBytes(out -> {
      out.u8(FORMAT);
      out.bool(decided != null);
      if (decided != null) {
        out.i64(decided.number());
        out.bytes(decided.value().bytes());
      }
      out.u16(slots.size());
      slots.forEach((number, slot) -> {
        out.i64(number);
        SynodCodec.ballot(out, slot.promised());
        SynodCodec.vote(out, slot.vote());
      });
    });
  }

  /** Throws {@link WireFormatException} on bytes that {@link #toBytes} cannot have written. */
  static AcceptorRecord fromBytes(byte[] bytes) {
    WireReader in = new WireReader(bytes);
    int format = in.u8();
    if (format != FORMAT) {
      throw new WireFormatException("acceptor record of format " + format);
    }
    Decided decided =
        in.bool() ? new Decided(in.i64(1, SynodCodec.DECREE), SynodCodec.value(in)) : null;
    SortedMap<Long, Slot> slots = new TreeMap<>();
    int count = in.u16();
    for (int i = 0; i < count; i++) {
      long number = in.i64(1, SynodCodec.DECREE);
      if (!slots.isEmpty() && slots.lastKey() >= number) {
        throw new WireFormatException("decree " + number + " out of order");
      }
      Ballot promised = SynodCodec.ballot(in);
      Vote vote = in.bool() ? new Vote(SynodCodec.ballot(in), SynodCodec.value(in)) : null;
      slots.put(number, new Slot(promised, vote));
    }
    if (in.remaining() > 0) {
      throw new WireFormatException(in.remaining() + " bytes after the record");
    }
    return new AcceptorRecord(decided, slots);
  }
}
