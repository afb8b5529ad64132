package org.starl.primitives.paths;

import java.util.ArrayList;
import java.util.List;
import org.starl.comms.Codec;
import org.starl.comms.WireFormatException;
import org.starl.comms.WireReader;
import org.starl.comms.WireWriter;
import org.starl.geometry.Point;

/** Encodes {@link TubeMessage} as in {@code docs/wire-format.md}. */
final class TubeCodec implements Codec<TubeMessage> {

  private static final int ASK = 1;
  private static final int VOTE = 2;
  private static final int REFUSE = 3;

  @Override
  public void write(TubeMessage message, WireWriter out) {
    switch (message) {
      case TubeMessage.Ask m -> {
        out.u8(ASK);
        holding(m.holding(), out);
      }
      case TubeMessage.Vote m -> {
        out.u8(VOTE);
        out.i64(m.version());
      }
      case TubeMessage.Refuse m -> {
        out.u8(REFUSE);
        out.i64(m.version());
        out.robot(m.who());
        holding(m.theirs(), out);
      }
    }
  }

  @Override
  public TubeMessage read(WireReader in) {
    int kind = in.u8();
    return switch (kind) {
      case ASK -> new TubeMessage.Ask(holding(in));
      case VOTE -> new TubeMessage.Vote(in.i64(0, "version"));
      case REFUSE -> new TubeMessage.Refuse(in.i64(0, "version"), in.robot(), holding(in));
      default -> throw new WireFormatException("tube message of kind " + kind);
    };
  }

  /** Encodes a holding and a flag for stable storage. */
  static byte[] toBytes(Holding holding, boolean flag) {
    return WireWriter.toBytes(out -> {
      out.bool(flag);
      holding(holding, out);
    });
  }

  /** Decodes what {@link #toBytes} encoded. */
  static TubeVoter.Note note(byte[] stored) {
    WireReader in = new WireReader(stored);
    boolean voted = in.bool();
    return new TubeVoter.Note(holding(in), voted);
  }

  private static void holding(Holding holding, WireWriter out) {
    out.i64(holding.version());
    tubes(holding.held(), out);
    tubes(holding.wanted(), out);
  }

  private static Holding holding(WireReader in) {
    return new Holding(in.i64(0, "version"), tubes(in, Holding.MAX_TUBES), tubes(in, 1));
  }

  private static void tubes(List<Tube> tubes, WireWriter out) {
    out.u8(tubes.size());
    for (Tube tube : tubes) {
      out.i32(tube.radiusMm());
      out.u8(tube.points().size());
      for (Point point : tube.points()) {
        out.i32((int) point.xMm());
        out.i32((int) point.yMm());
      }
    }
  }

  private static List<Tube> tubes(WireReader in, int most) {
    int count = in.u8();
    if (count > most) {
      throw new WireFormatException(count + " tubes");
    }
    List<Tube> tubes = new ArrayList<>(count);
    for (int i = 0; i < count; i++) {
      int radiusMm = in.i32();
      int points = in.u8();
      if (radiusMm <= 0 || radiusMm > PlanTask.MAX_MM || points == 0 || points > Tube.MAX_POINTS) {
        throw new WireFormatException("tube of " + points + " points, radius " + radiusMm);
      }
      List<Point> line = new ArrayList<>(points);
      for (int j = 0; j < points; j++) {
        int xMm = coordinate(in);
        line.add(new Point(xMm, coordinate(in)));
      }
      tubes.add(new Tube(line, radiusMm));
    }
    return tubes;
  }

  private static int coordinate(WireReader in) {
    int mm = in.i32();
    if (Math.abs((long) mm) > PlanTask.MAX_MM) {
      throw new WireFormatException("coordinate " + mm);
    }
    return mm;
  }
}
