package org.starl.primitives.election;

import java.util.Arrays;
import org.starl.comms.Codec;
import org.starl.comms.WireFormatException;
import org.starl.comms.WireReader;
import org.starl.comms.WireWriter;
import org.starl.id.ProcessId;
import org.starl.primitives.agreement.SynodCodec;
import org.starl.primitives.agreement.Value;
import org.starl.primitives.election.ElectionMessage.Candidacy;
import org.starl.primitives.election.ElectionMessage.Elected;

/**
 * The bytes of {@link ElectionMessage}s, and of a leader as the Synod's value, as {@code
 * docs/wire-format.md} has them.
 */
final class ElectionCodec implements Codec<ElectionMessage>, SynodCodec.Format {

  private static final int CANDIDACY = 1;
  private static final int ELECTED = 2;

  @Override
  public void write(ElectionMessage message, WireWriter out) {
    out.u8(message instanceof Candidacy ? CANDIDACY : ELECTED);
    out.process(message.from());
    out.i64(message.term());
    switch (message) {
      case Candidacy m -> out.i64(m.draw());
      case Elected m -> out.process(m.leader());
    }
  }

  @Override
  public ElectionMessage read(WireReader in) {
    int kind = in.u8();
    ProcessId from = in.process();
    long term = in.i64();
    if (term < 1) {
      throw new WireFormatException("election term " + term);
    }
    return switch (kind) {
      case CANDIDACY -> new Candidacy(from, term, in.i64());
      case ELECTED -> new Elected(from, term, in.process());
      default -> throw new WireFormatException("election message of kind " + kind);
    };
  }

  @Override
  public void checkValue(Value value) {
    leader(value);
  }

  @Override
  public void checkWish(Value wish) {
    if (wish.length() > 0) {
      throw new WireFormatException("a wish where none is expected");
    }
  }

  static Value value(ProcessId leader) {
    byte[] buffer = new byte[Value.MAX_BYTES];
    WireWriter out = new WireWriter(buffer);
    out.process(leader);
    return Value.of(Arrays.copyOf(buffer, out.length()));
  }

  /** Throws {@link WireFormatException} on what {@link #value} cannot have written. */
  static ProcessId leader(Value value) {
    WireReader in = new WireReader(value.bytes());
    ProcessId leader = in.process();
    if (in.remaining() > 0) {
      throw new WireFormatException(in.remaining() + " bytes after a leader");
    }
    return leader;
  }
}
