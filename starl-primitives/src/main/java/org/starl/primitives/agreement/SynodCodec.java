package org.starl.primitives.agreement;

import org.jspecify.annotations.Nullable;
import org.starl.comms.Codec;
import org.starl.comms.WireFormatException;
import org.starl.comms.WireReader;
import org.starl.comms.WireWriter;
import org.starl.primitives.agreement.SynodMessage.Accept;
import org.starl.primitives.agreement.SynodMessage.Accepted;
import org.starl.primitives.agreement.SynodMessage.Decided;
import org.starl.primitives.agreement.SynodMessage.Nack;
import org.starl.primitives.agreement.SynodMessage.Prepare;
import org.starl.primitives.agreement.SynodMessage.Promise;
import org.starl.primitives.agreement.SynodMessage.Query;
import org.starl.primitives.agreement.SynodMessage.Vote;

/** The bytes of {@link SynodMessage}s, as in {@code docs/wire-format.md}. */
public final class SynodCodec implements Codec<SynodMessage> {

  private static final int PREPARE = 1;
  private static final int PROMISE = 2;
  private static final int NACK = 3;
  private static final int ACCEPT = 4;
  private static final int ACCEPTED = 5;
  private static final int DECIDED = 6;
  private static final int QUERY = 7;

  /** Names the number of a decree in errors. */
  static final String DECREE = "decree number";

  private final Format format;

  /**
   * @param format rejects malformed values and wishes, so that their datagrams are dropped on arrival
   */
  public SynodCodec(Format format) {
    this.format = format;
  }

  /** The values and wishes that the owner of a channel accepts. */
  @FunctionalInterface
  public interface Format {

    /** Throws {@link WireFormatException} if {@code value} is malformed. */
    void checkValue(Value value);

    /** Throws {@link WireFormatException} if {@code wish} is malformed; by default only empty is not. */
    default void checkWish(Value wish) {
      if (wish.length() > 0) {
        throw new WireFormatException("a wish where none is expected");
      }
    }

    /** A value is what {@code codec} reads; wishes are empty. */
    static Format of(Codec<?> codec) {
      return value -> value.read("a value", codec::read);
    }
  }

  @Override
  public void write(SynodMessage message, WireWriter out) {
    switch (message) {
      case Prepare m -> {
        begin(out, PREPARE, m.number());
        ballot(out, m.ballot());
        out.bytes(m.wish().bytes());
      }
      case Promise m -> {
        begin(out, PROMISE, m.number());
        ballot(out, m.ballot());
        vote(out, m.vote());
        out.u8(m.wishes().size());
        for (Value wish : m.wishes()) {
          out.bytes(wish.bytes());
        }
      }
      case Nack m -> {
        begin(out, NACK, m.number());
        ballot(out, m.ballot());
        ballot(out, m.promised());
      }
      case Accept m -> {
        begin(out, ACCEPT, m.number());
        ballot(out, m.ballot());
        out.bytes(m.value().bytes());
      }
      case Accepted m -> {
        begin(out, ACCEPTED, m.number());
        ballot(out, m.ballot());
      }
      case Decided m -> {
        begin(out, DECIDED, m.number());
        out.bytes(m.value().bytes());
      }
      case Query m -> begin(out, QUERY, m.number());
    }
  }

  @Override
  public SynodMessage read(WireReader in) {
    int kind = in.u8();
    long number = in.i64(kind == QUERY ? 0 : 1, DECREE);
    return switch (kind) {
      case PREPARE -> new Prepare(number, ballot(in), wish(in));
      case PROMISE -> new Promise(number, ballot(in), vote(in), in.list(in.u8(), this::wish));
      case NACK -> new Nack(number, ballot(in), ballot(in));
      case ACCEPT -> new Accept(number, ballot(in), checkedValue(in));
      case ACCEPTED -> new Accepted(number, ballot(in));
      case DECIDED -> new Decided(number, checkedValue(in));
      case QUERY -> new Query(number);
      default -> throw new WireFormatException("synod message of kind " + kind);
    };
  }

  private static void begin(WireWriter out, int kind, long number) {
    out.u8(kind);
    out.i64(number);
  }

  private @Nullable Vote vote(WireReader in) {
    return in.bool() ? new Vote(ballot(in), checkedValue(in)) : null;
  }

  private Value checkedValue(WireReader in) {
    Value value = value(in);
    format.checkValue(value);
    return value;
  }

  private Value wish(WireReader in) {
    Value wish = value(in);
    format.checkWish(wish);
    return wish;
  }

  static void vote(WireWriter out, @Nullable Vote vote) {
    out.bool(vote != null);
    if (vote != null) {
      ballot(out, vote.ballot());
      out.bytes(vote.value().bytes());
    }
  }

  static void ballot(WireWriter out, Ballot ballot) {
    out.i64(ballot.round());
    out.process(ballot.proposer());
  }

  static Ballot ballot(WireReader in) {
    return new Ballot(in.i64(1, "round"), in.process());
  }

  static Value value(WireReader in) {
    byte[] bytes = in.bytes();
    if (bytes.length > Value.MAX_BYTES) {
      throw new WireFormatException("a value of " + bytes.length + " bytes");
    }
    return Value.of(bytes);
  }
}
