package org.starl.robot.create;

import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.util.Arrays;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;

/** One end of a line in memory; closing either end ends both. */
final class MemoryLink implements ByteLink {

  private static final byte[] END = {};

  private final BlockingQueue<byte[]> in;
  private final BlockingQueue<byte[]> out;

  private MemoryLink(BlockingQueue<byte[]> in, BlockingQueue<byte[]> out) {
    this.in = in;
    this.out = out;
  }

  /** Both ends. */
  static MemoryLink[] pair() {
    BlockingQueue<byte[]> there = new LinkedBlockingQueue<>();
    BlockingQueue<byte[]> back = new LinkedBlockingQueue<>();
    return new MemoryLink[] {new MemoryLink(there, back), new MemoryLink(back, there)};
  }

  @Override
  public InputStream input() {
    return new InputStream() {
      @Override
      public int read() {
        throw new UnsupportedOperationException("read bytes in rows");
      }

      @Override
      public int read(byte[] into, int offset, int length) throws IOException {
        try {
          byte[] bytes = in.take();
          if (bytes == END) {
            in.add(END);
            return -1;
          }
          System.arraycopy(bytes, 0, into, offset, bytes.length);
          return bytes.length;
        } catch (InterruptedException e) {
          throw new IOException(e);
        }
      }
    };
  }

  @Override
  public OutputStream output() {
    return new OutputStream() {
      @Override
      public void write(int b) {
        out.add(new byte[] {(byte) b});
      }

      @Override
      public void write(byte[] bytes, int offset, int length) {
        // What a reader takes at once: the host's and the driver's buffers have 256 bytes.
        for (int from = offset; from < offset + length; from += 256) {
          int to = Math.min(from + 256, offset + length);
          out.add(Arrays.copyOfRange(bytes, from, to));
        }
      }
    };
  }

  @Override
  public void close() {
    in.add(END);
    out.add(END);
  }

  @Override
  public String toString() {
    return "a line in memory";
  }
}
