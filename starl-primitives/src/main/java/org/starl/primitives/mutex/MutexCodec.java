package org.starl.primitives.mutex;

import java.util.SortedSet;
import org.starl.comms.Codec;
import org.starl.comms.WireFormatException;
import org.starl.comms.WireReader;
import org.starl.comms.WireWriter;
import org.starl.id.ProcessId;
import org.starl.primitives.membership.Sections;

/** Encodes {@link MutexMessage} as in {@code docs/wire-format.md}. */
final class MutexCodec implements Codec<MutexMessage> {

  private static final int REQ = 1;
  private static final int OK = 2;
  private static final int REM = 3;
  private static final int NOTED = 4;
  private static final int FENCE_Q = 5;
  private static final int FENCE = 6;
  private static final int FENCED = 7;

  /** The limit of datagram headers: a received time must not make a clock overflow. */
  private static final long MAX_TS = (1L << 62) - 1;

  @Override
  public void write(MutexMessage message, WireWriter out) {
    switch (message) {
      case MutexMessage.Req req -> {
        head(REQ, req, out);
        out.i64(req.num());
        out.i64(req.admittedBy());
        out.i64(req.ts());
        Sections.write(req.want(), out);
      }
      case MutexMessage.Ok ok -> {
        head(OK, ok, out);
        out.i64(ok.num());
      }
      case MutexMessage.Rem rem -> {
        head(REM, rem, out);
        out.i64(rem.num());
        Sections.write(rem.left(), out);
      }
      case MutexMessage.Noted noted -> {
        head(NOTED, noted, out);
        out.i64(noted.num());
      }
      case MutexMessage.FenceQ question -> {
        head(FENCE_Q, question, out);
        out.process(question.suspect());
        out.i64(question.admittedBy());
      }
      case MutexMessage.Fence fence -> {
        head(FENCE, fence, out);
        out.process(fence.suspect());
        Sections.write(fence.open(), out);
      }
      case MutexMessage.Fenced fenced -> head(FENCED, fenced, out);
    }
  }

  @Override
  public MutexMessage read(WireReader in) {
    int kind = in.u8();
    ProcessId from = in.process();
    ProcessId to = in.process();
    if (from.equals(to)) {
      throw new WireFormatException("message from " + from + " to itself");
    }
    return switch (kind) {
      case REQ -> {
        long num = num(in);
        long admittedBy = admittedBy(in);
        long ts = in.i64(1, "logical time");
        if (ts > MAX_TS) {
          throw new WireFormatException("logical time " + ts);
        }
        SortedSet<String> want = Sections.read(in);
        if (want.isEmpty()) {
          throw new WireFormatException("request without sections");
        }
        yield new MutexMessage.Req(from, to, num, admittedBy, ts, want);
      }
      case OK -> new MutexMessage.Ok(from, to, num(in));
      case REM -> new MutexMessage.Rem(from, to, num(in), Sections.read(in));
      case NOTED -> new MutexMessage.Noted(from, to, num(in));
      case FENCE_Q -> new MutexMessage.FenceQ(from, to, suspect(in, from), admittedBy(in));
      case FENCE -> new MutexMessage.Fence(from, to, suspect(in, from), Sections.read(in));
      case FENCED -> new MutexMessage.Fenced(from, to);
      default -> throw new WireFormatException("message kind " + kind);
    };
  }

  private static void head(int kind, MutexMessage message, WireWriter out) {
    out.u8(kind);
    out.process(message.from());
    out.process(message.to());
  }

  private static ProcessId suspect(WireReader in, ProcessId from) {
    ProcessId suspect = in.process();
    if (suspect.equals(from)) {
      throw new WireFormatException(from + " suspects itself");
    }
    return suspect;
  }

  private static long num(WireReader in) {
    return in.i64(1, "request number");
  }

  private static long admittedBy(WireReader in) {
    return in.i64(1, "view number");
  }
}
