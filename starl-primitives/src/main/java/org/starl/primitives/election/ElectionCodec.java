package org.starl.primitives.election;

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
 * The bytes of {@link ElectionMessage}s, and of a leader as the Synod's value, as in {@code
 * docs/wire-format.md}.
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
    long term = in.i64(1, "election term");
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

  static Value value(ProcessId leader) {
    return Value.write(out -> out.process(leader));
  }

  /** Throws {@link WireFormatException} on what {@link #value} cannot have written. */
  static ProcessId leader(Value value) {
    return value.read("a leader", WireReader::process);
  }
}
