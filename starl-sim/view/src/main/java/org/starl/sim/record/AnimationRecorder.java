package org.starl.sim.record;

import java.awt.image.BufferedImage;
import java.io.Closeable;
import java.io.IOException;
import java.io.OutputStream;
import java.io.UncheckedIOException;
import java.util.ArrayDeque;
import java.util.Deque;
import org.starl.geometry.Obstacles;
import org.starl.sim.Failure;
import org.starl.sim.SimResult;

/**
 * Writes an animation of a run, 20 frames a second: one frame per {@code everyNs} of simulated time.
 * It can also write only the time around the first violation. It holds no frame that it has written.
 */
public final class AnimationRecorder extends SceneRecorder implements Closeable {

  /** A file of frames. */
  interface FrameWriter extends Closeable {

    /** Writes the next frame; all have one size. */
    void write(BufferedImage frame) throws IOException;
  }

  /** The kind of file. */
  public enum Kind {
    /** It repeats for ever. */
    GIF,
    /** Video in H.264. */
    MP4
  }

  /** Frames kept before and after a violation. */
  private static final int FRAMES_BEFORE = 60;

  private static final int FRAMES_AFTER = 20;

  private final long everyNs;
  private final int widthPx;
  private final FrameWriter writer;

  /** Waiting for a violation. */
  private final Deque<BufferedImage> frames = new ArrayDeque<>();

  private long nextNs;
  private int framesLeft = Integer.MAX_VALUE;
  private boolean isWritten;

  /**
   * @param everyNs simulated time between two frames, above 0
   * @param widthPx width of the animation, above 0
   * @param ofViolation whether to write only the frames around the first violation; nothing if there
   *     is none
   */
  public AnimationRecorder(
      Kind kind,
      OutputStream out,
      Obstacles obstacles,
      Layer layer,
      long everyNs,
      int widthPx,
      boolean ofViolation) {
    super(obstacles, layer);
    if (everyNs <= 0 || widthPx <= 0) {
      throw new IllegalArgumentException(
          "a frame every " + everyNs + " ns, " + widthPx + " px wide: expected both above 0");
    }
    this.everyNs = everyNs;
    this.widthPx = widthPx;
    isWritten = !ofViolation;
    writer = kind == Kind.GIF ? new GifWriter(out) : new Mp4Writer(out);
  }

  @Override
  public void wentWrong(Failure failure) {
    super.wentWrong(failure);
    if (!isWritten && failure.kind() == Failure.Kind.VIOLATED) {
      isWritten = true;
      framesLeft = FRAMES_AFTER;
    }
  }

  @Override
  public void finished(SimResult result) {
    takeBefore(result.endNs() + 1);
  }

  @Override
  void takeBefore(long timeNs) {
    while (nextNs < timeNs && framesLeft > 0) {
      frames.add(Filmstrip.scaled(paint(nextNs), widthPx));
      nextNs += everyNs;
      if (isWritten) {
        framesLeft--;
        writeFrames();
      } else if (frames.size() > FRAMES_BEFORE) {
        frames.remove();
      }
    }
  }

  private void writeFrames() {
    try {
      while (!frames.isEmpty()) {
        writer.write(frames.remove());
      }
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  @Override
  public void close() throws IOException {
    try (writer) {
      if (isWritten) {
        writeFrames();
      }
    }
  }
}
