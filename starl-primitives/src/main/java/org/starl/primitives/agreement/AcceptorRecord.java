package org.starl.primitives.agreement;

import static org.starl.shape.Shapes.part;

import java.util.Collections;
import java.util.Optional;
import java.util.SortedMap;
import java.util.TreeMap;
import org.jspecify.annotations.Nullable;
import org.starl.primitives.agreement.SynodMessage.Decided;
import org.starl.primitives.agreement.SynodMessage.Vote;
import org.starl.shape.Shape;
import org.starl.shape.Shapes;
import org.starl.shape.WireFormatException;
import org.starl.shape.WireReader;
import org.starl.shape.WireWriter;

/**
 * The memory of an acceptor that must survive a restart.
 *
 * @param decided the latest decree it knows, or null
 * @param slots its promise and vote for each later number that it was asked about
 */
record AcceptorRecord(@Nullable Decided decided, SortedMap<Long, Slot> slots) {

  static final AcceptorRecord NEW = new AcceptorRecord(null, new TreeMap<>());

  private static final int FORMAT = 1;
  private static final Shape<Optional<Decided>> DECIDED =
      Shapes.optional(Decided.shape(Value.SHAPE));
  private static final Shape<Long> NUMBER = Shapes.atLeast(1, "decree number");

  AcceptorRecord {
    slots = Collections.unmodifiableSortedMap(new TreeMap<>(slots));
  }

  /** The promise and the vote for one number. */
  record Slot(Ballot promised, @Nullable Vote vote) {
    private static final Shape<Slot> SHAPE =
        Shapes.of(
            Slot.class,
            part("promised", Ballot.SHAPE, Slot::promised),
            part(
                "vote",
                Shapes.optional(Vote.shape(Value.SHAPE)),
                slot -> Optional.ofNullable(slot.vote())),
            (promised, vote) -> new Slot(promised, vote.orElse(null)));
  }

  byte[] toBytes() {
    return WireWriter.toBytes(out -> {
      out.u8(FORMAT);
      DECIDED.write(Optional.ofNullable(decided), out);
      out.u16(slots.size());
      slots.forEach((number, slot) -> {
        NUMBER.write(number, out);
        Slot.SHAPE.write(slot, out);
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
    Decided decided = DECIDED.read(in).orElse(null);
    SortedMap<Long, Slot> slots = new TreeMap<>();
    int count = in.u16();
    for (int i = 0; i < count; i++) {
      long number = NUMBER.read(in);
      if (!slots.isEmpty() && slots.lastKey() >= number) {
        throw new WireFormatException("decree " + number + " out of order");
      }
      slots.put(number, Slot.SHAPE.read(in));
    }
    if (in.remaining() > 0) {
      throw new WireFormatException(in.remaining() + " bytes after the record");
    }
    return new AcceptorRecord(decided, slots);
  }
}
