package org.starl.primitives.agreement;

import static org.starl.shape.Shapes.U8;
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

  private static final Shape<AcceptorRecord> SHAPE =
      Shapes.of(
          AcceptorRecord.class,
          part("format", U8.where(AcceptorRecord::checkFormat), record -> FORMAT),
          part(
              "decided",
              Shapes.optional(Decided.shape(Value.SHAPE)),
              record -> Optional.ofNullable(record.decided())),
          part(
              "slots",
              Shapes.map(Shapes.atLeast(1, "decree number"), Slot.SHAPE, 0xFFFF),
              AcceptorRecord::slots),
          (format, decided, slots) -> new AcceptorRecord(decided.orElse(null), slots));

  private static void checkFormat(int format) {
    if (format != FORMAT) {
      throw new IllegalArgumentException("acceptor record of format " + format);
    }
  }

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
    return WireWriter.toBytes(out -> SHAPE.write(this, out));
  }

  /** Throws {@link WireFormatException} on bytes that {@link #toBytes} cannot have written. */
  static AcceptorRecord fromBytes(byte[] bytes) {
    WireReader in = new WireReader(bytes);
    AcceptorRecord record = SHAPE.read(in);
    in.expectEnd();
    return record;
  }
}
