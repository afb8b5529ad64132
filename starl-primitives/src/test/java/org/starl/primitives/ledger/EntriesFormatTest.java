package org.starl.primitives.ledger;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.starl.primitives.agreement.SynodCodec;
import org.starl.primitives.agreement.SynodMessage;
import org.starl.primitives.agreement.SynodMessage.Decided;
import org.starl.primitives.agreement.Value;
import org.starl.shape.Shape;
import org.starl.shape.Shapes;
import org.starl.shape.WireFormatException;
import org.starl.shape.WireReader;
import org.starl.shape.WireWriter;

/** Which decrees a robot accepts from others. */
class EntriesFormatTest {

  private static final Shape<SynodMessage> TENS =
      SynodCodec.of(
          new TaskLedger.EntriesFormat(
              Shapes.U16.where(number -> {
                if (number % 10 != 0) {
                  throw new IllegalArgumentException(number + ": expected a multiple of 10");
                }
              })));

  private static SynodMessage read(byte[] what) {
    LedgerEntry add = new LedgerEntry.Add(Seen.T, Value.of(what));
    Value value = Value.write(out -> LedgerEntry.LIST.write(List.of(Seen.START_A, add), out));
    SynodMessage decided = new Decided(1, value);
    byte[] bytes = WireWriter.toBytes(out -> SynodMessage.SHAPE.write(decided, out));
    return TENS.read(new WireReader(bytes));
  }

  /** Else the app would get it, from a robot of another version or one without a key. */
  @Test
  void aTaskThatTheAppCannotReadIsRefusedOnArrival() {
    assertThat(read(new byte[] {0, 20})).isInstanceOf(Decided.class);
    for (byte[] what : new byte[][] {{0, 21}, {0}, {0, 20, 0}}) {
      assertThatThrownBy(() -> read(what)).isInstanceOf(WireFormatException.class);
    }
  }
}
