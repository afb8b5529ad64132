package org.starl.apps.lightpaint.view;

import com.github.weisj.jsvg.renderer.output.Output;
import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Paint;
import java.awt.Shape;
import java.awt.geom.AffineTransform;
import java.lang.reflect.InvocationHandler;
import java.lang.reflect.InvocationTargetException;
import java.lang.reflect.Method;
import java.lang.reflect.Proxy;
import java.util.function.Supplier;
import org.jspecify.annotations.Nullable;

/**
 * What JSVG draws on to have its outlines written down and nothing drawn. A proxy, because thirty
 * methods of {@link Output} would do nothing but pass on.
 */
final class RecordingOutput implements InvocationHandler {

  private final Output kept;
  private final Outlines outlines;
  private Paint paint;

  /** Takes what is drawn with a stroke. */
  interface Outlines {
    void drawn(Shape shape, AffineTransform toUnits, BasicStroke stroke, Paint paint);
  }

  private RecordingOutput(Output kept, Outlines outlines, Paint paint) {
    this.kept = kept;
    this.outlines = outlines;
    this.paint = paint;
  }

  /**
   * @param kept keeps transforms and strokes
   */
  static Output over(Output kept, Outlines outlines) {
    return proxy(new RecordingOutput(kept, outlines, Color.BLACK));
  }

  private static Output proxy(RecordingOutput handler) {
    Class<?>[] types = {Output.class};
    return (Output) Proxy.newProxyInstance(Output.class.getClassLoader(), types, handler);
  }

  @Override
  public @Nullable Object invoke(Object proxy, Method method, Object @Nullable [] given)
      throws Throwable {
    Object[] arguments = given == null ? new Object[0] : given;
    switch (method.getName()) {
      case "drawShape" -> {
        if (kept.stroke() instanceof BasicStroke stroke) {
          outlines.drawn((Shape) arguments[0], kept.transform(), stroke, paint);
        }
        return null;
      }
      case "fillShape", "drawImage", "debugPaint", "applyClip", "setClip" -> {
        return null;
      }
      case "supportsFilters" -> {
        return false;
      }
      case "setPaint" -> {
        Object value = arguments[0] instanceof Supplier<?> later ? later.get() : arguments[0];
        paint = value instanceof Paint some ? some : Color.BLACK;
        return null;
      }
      case "createChild" -> {
        return proxy(new RecordingOutput(kept.createChild(), outlines, paint));
      }
      default -> {
        // Keeps what is set, for what is drawn later.
      }
    }
    try {
      return method.invoke(kept, arguments);
    } catch (InvocationTargetException thrown) {
      throw thrown.getCause();
    }
  }
}
