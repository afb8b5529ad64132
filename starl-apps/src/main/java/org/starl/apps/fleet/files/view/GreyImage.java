package org.starl.apps.fleet.files.view;

import java.awt.image.BufferedImage;
import java.awt.image.ColorModel;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Iterator;
import java.util.zip.CRC32;
import javax.imageio.ImageIO;
import javax.imageio.ImageReader;
import javax.imageio.stream.MemoryCacheImageInputStream;
import org.starl.input.BadInput;
import org.starl.input.TextFile;

/** The pixels of a PGM or PNG image. Row 0 is the upper one. */
public final class GreyImage {

  private static final String EXPECTED = "expected an image, PGM (P2 or P5) or PNG";

  /** 4000 x 4000: 200 m x 200 m at 5 cm. */
  private static final int MOST_PIXELS = 16_000_000;

  /** The name of a PNG's last part. */
  private static final int IEND = 0x49454e44;

  private final int width;
  private final int height;
  private final boolean hasAlpha;

  /** From 0, black, to 1, row by row; the mean of the colours. */
  private final float[] brightness;

  /** From 0 to 1. */
  private final float[] opacity;

  private GreyImage(int width, int height, boolean hasAlpha) {
    this.width = width;
    this.height = height;
    this.hasAlpha = hasAlpha;
    brightness = new float[width * height];
    opacity = new float[hasAlpha ? width * height : 0];
  }

  public int width() {
    return width;
  }

  public int height() {
    return height;
  }

  public boolean hasAlpha() {
    return hasAlpha;
  }

  /** From 0, black, to 1: the mean of the colours. */
  public double brightness(int x, int y) {
    return brightness[y * width + x];
  }

  /** From 0 to 1; 1 without an alpha channel. */
  public double opacity(int x, int y) {
    return hasAlpha ? opacity[y * width + x] : 1;
  }

  /**
   * The image of a file; its first bytes decide the format.
   *
   * @throws BadInput if it cannot be read, or has more than 16 million pixels
   */
  public static GreyImage read(Path file) {
    byte[] bytes = TextFile.bytes(file, EXPECTED);
    String magic = new String(bytes, 0, Math.min(2, bytes.length), StandardCharsets.ISO_8859_1);
    return switch (magic) {
      case "P2", "P5" -> new Pgm(file.toString(), bytes).image(magic.equals("P5"));
      case "\u0089P" -> png(file.toString(), bytes);
      default -> throw new BadInput(file + ": is no such image; " + EXPECTED);
    };
  }

  private static GreyImage empty(String file, long width, long height, boolean hasAlpha) {
    if (width < 1 || height < 1 || width * height > MOST_PIXELS) {
      throw new BadInput(
          file + ": " + width + " x " + height + ": expected 1 to " + MOST_PIXELS + " pixels");
    }
    return new GreyImage((int) width, (int) height, hasAlpha);
  }

  private static GreyImage png(String file, byte[] bytes) {
    try (MemoryCacheImageInputStream in =
        new MemoryCacheImageInputStream(new ByteArrayInputStream(bytes))) {
      Iterator<ImageReader> readers = ImageIO.getImageReaders(in);
      if (readers.hasNext() && isWhole(ByteBuffer.wrap(bytes))) {
        ImageReader reader = readers.next();
        reader.setInput(in);
        // Before it is read: few bytes may stand for many pixels.
        empty(file, reader.getWidth(0), reader.getHeight(0), false);
        return png(file, reader.read(0));
      }
    } catch (IOException | RuntimeException e) {
      if (e instanceof BadInput tooLarge) {
        throw tooLarge;
      }
      // ImageIO has exceptions of both kinds for broken files.
    }
    throw new BadInput(file + ": is a broken PNG image; " + EXPECTED);
  }

  /** Whether each part of a PNG, up to its end, has its checksum: ImageIO does not look. */
  private static boolean isWhole(ByteBuffer png) {
    png.position(8); // after the signature
    while (png.remaining() >= 12) {
      long length = png.getInt() & 0xffff_ffffL;
      if (length > png.remaining() - 8) {
        return false;
      }
      CRC32 sum = new CRC32();
      boolean isEnd = png.getInt(png.position()) == IEND;
      sum.update(png.slice(png.position(), 4 + (int) length));
      png.position(png.position() + 4 + (int) length);
      if (png.getInt() != (int) sum.getValue()) {
        return false;
      }
      if (isEnd) {
        return true;
      }
    }
    return false;
  }

  private static GreyImage png(String file, BufferedImage from) {
    ColorModel model = from.getColorModel();
    GreyImage image = empty(file, from.getWidth(), from.getHeight(), model.hasAlpha());
    // getRGB changes the brightness of grey.
    boolean isGrey = model.getNumColorComponents() == 1;
    float most = (1 << model.getComponentSize(0)) - 1;
    for (int y = 0; y < image.height; y++) {
      for (int x = 0; x < image.width; x++) {
        int argb = from.getRGB(x, y);
        int at = y * image.width + x;
        image.brightness[at] =
            isGrey
                ? from.getRaster().getSample(x, y, 0) / most
                : (((argb >> 16) & 255) + ((argb >> 8) & 255) + (argb & 255)) / 765f;
        if (image.hasAlpha) {
          image.opacity[at] = (argb >>> 24) / 255f;
        }
      }
    }
    return image;
  }

  /** Reads a PGM image: magic number, width, height, largest value, then values. */
  private static final class Pgm {

    private static final String SPACES = " \t\n\u000b\f\r";

    private final String file;
    private final byte[] bytes;
    private int next = 2;

    Pgm(String file, byte[] bytes) {
      this.file = file;
      this.bytes = bytes;
    }

    GreyImage image(boolean isBinary) {
      requireSpace();
      GreyImage image = empty(file, number(Integer.MAX_VALUE), number(Integer.MAX_VALUE), false);
      int most = number(65_535);
      if (most == 0) {
        throw wrong("0", "a largest value from 1 to 65535");
      }
      requireSpace();
      next++;
      int width = most > 255 ? 2 : 1;
      long needed = (long) image.brightness.length * width;
      if (isBinary && bytes.length - next < needed) {
        throw new BadInput(
            file + ": ends early: expected " + needed + " bytes of pixels after the header");
      }
      for (int i = 0; i < image.brightness.length; i++) {
        int value = isBinary ? binary(width) : number(most);
        if (value > most) {
          throw wrong(String.valueOf(value), "at most " + most + ", the largest value");
        }
        image.brightness[i] = (float) value / most;
      }
      if (!isBinary) {
        requireEnd("only " + image.width + " x " + image.height + " values");
      }
      return image;
    }

    private void requireSpace() {
      if (next < bytes.length && !isSpace()) {
        throw wrongHere("white space");
      }
    }

    private void requireEnd(String expected) {
      skipSpaces();
      if (next < bytes.length) {
        throw wrongHere(expected);
      }
    }

    private BadInput wrongHere(String expected) {
      return wrong(String.valueOf((char) (bytes[next] & 255)), expected);
    }

    /** Whether white space or a comment is next. */
    private boolean isSpace() {
      return SPACES.indexOf(bytes[next]) >= 0 || bytes[next] == '#';
    }

    private int binary(int width) {
      int value = 0;
      for (int i = 0; i < width; i++) {
        value = (value << 8) | (bytes[next++] & 255);
      }
      return value;
    }

    /** Skips white space and comments. */
    private void skipSpaces() {
      while (next < bytes.length && isSpace()) {
        if (bytes[next] == '#') {
          while (next < bytes.length && bytes[next] != '\n') {
            next++;
          }
        } else {
          next++;
        }
      }
    }

    private int number(int most) {
      skipSpaces();
      int start = next;
      long value = 0;
      while (next < bytes.length && Character.isDigit(bytes[next]) && value <= most) {
        value = value * 10 + bytes[next++] - '0';
      }
      if (start == next || value > most) {
        int end = Math.min(bytes.length, Math.max(next, start + 1));
        String text =
            new String(Arrays.copyOfRange(bytes, start, end), StandardCharsets.ISO_8859_1);
        throw wrong(text, "a whole number from 0 to " + most);
      }
      return (int) value;
    }

    private BadInput wrong(String given, String expected) {
      int line = 1;
      for (int i = 0; i < Math.min(next, bytes.length); i++) {
        line += bytes[i] == '\n' ? 1 : 0;
      }
      return BadInput.at(file, line, BadInput.quote(given) + ": expected " + expected);
    }
  }
}
