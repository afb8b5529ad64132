package org.starl.primitives.mutex;

import java.util.SortedSet;
import java.util.TreeSet;
import org.starl.ProcessId;
import org.starl.comms.Codec;
import org.starl.comms.WireFormatException;
import org.starl.comms.WireReader;
import org.starl.comms.WireWriter;

/**
 * The bytes of {@link MutexMessage}: kind (u8), from, to (process), num (i64); then of a request
 * admittedBy, ts (i64) and its sections, of a rest its sections. Sections are their number (u8) and
 * their names in ascending order.
 */
final class MutexCodec implements Codec<MutexMessage> {

  private static final int REQ = 1;
  private static final int OK = 2;
  private static final int REM = 3;

  /** As in datagrams' headers: nothing that arrives drives a clock to its overflow. */
  private static final long MAX_TS = (1L << 62) - 1;

  @Override
  public void write(MutexMessage message, WireWriter out) {
    switch (message) {
      case MutexMessage.Req req -> {
        head(REQ, req, req.num(), out);
        out.i64(req.admittedBy());
        out.i64(req.ts());
        sections(req.want(), out);
      }
      case MutexMessage.Ok ok -> head(OK, ok, ok.num(), out);
      case MutexMessage.Rem rem -> {
        head(REM, rem, rem.num(), out);
        sections(rem.left(), out);
      }
    }
  }

  @Override
  public MutexMessage read(WireReader in) {
    int kind = in.u8();
    ProcessId from = in.process();
    ProcessId to = in.process();
    if (from.equals(to)) {
      throw new WireFormatException("a message of " + from + " to itself");
    }
    long num = positive(in.i64(), "request number");
    return switch (kind) {
      case REQ -> {
        long admittedBy = positive(in.i64(), "view number");
        long ts = positive(in.i64(), "logical time");
        if (ts > MAX_TS) {
          throw new WireFormatException("logical time " + ts);
        }
        SortedSet<String> want = sections(in);
        if (want.isEmpty()) {
          throw new WireFormatException("a request for nothing");
        }
        yield new MutexMessage.Req(from, to, num, admittedBy, ts, want);
      }
      case OK -> new MutexMessage.Ok(from, to, num);
      case REM -> new MutexMessage.Rem(from, to, num, sections(in));
      default -> throw new WireFormatException("message kind " + kind);
    };
  }

  private static void head(int kind, MutexMessage message, long num, WireWriter out) {
    out.u8(kind);
    out.process(message.from());
    out.process(message.to());
    out.i64(num);
  }

  private static void sections(SortedSet<String> names, WireWriter out) {
    out.u8(names.size());
    for (String name : names) {
      out.string(name);
    }
  }

  // Only the ascending order is accepted, so that every message has one spelling.
  private static SortedSet<String> sections(WireReader in) {
    int count = in.u8();
    if (count > Sections.MAX_COUNT) {
      throw new WireFormatException(count + " sections");
    }
    TreeSet<String> names = new TreeSet<>();
    for (int i = 0; i < count; i++) {
      String name = in.string();
      if (!Sections.isValid(name) || (!names.isEmpty() && names.last().compareTo(name) >= 0)) {
        throw new WireFormatException("section name");
      }
      names.add(name);
    }
    return Sections.copyOf(names);
  }

  private static long positive(long value, String what) {
    if (value <= 0) {
      throw new WireFormatException(what + " " + value);
    }
    return value;
  }
}
