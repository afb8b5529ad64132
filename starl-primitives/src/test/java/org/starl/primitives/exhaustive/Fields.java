package org.starl.primitives.exhaustive;

import java.lang.reflect.Field;
import java.lang.reflect.Modifier;
import java.util.Collection;
import java.util.Map;
import java.util.Set;

/** The fields of an object as text, for a protocol that does not print its state. */
public final class Fields {

  private Fields() {}

  /**
   * The fields of {@code object} and of all objects of StarL that they hold, but for functions, other
   * objects' types in {@code leftOut}, and fields with a name in it.
   */
  public static String text(Object object, Set<?> leftOut) {
    StringBuilder text = new StringBuilder();
    add(object, leftOut, text);
    return text.toString();
  }

  private static void add(Object value, Set<?> leftOut, StringBuilder text) {
    if (value instanceof Map<?, ?> map) {
      map.forEach((key, held) -> {
        text.append(key).append('=');
        add(held, leftOut, text);
      });
      text.append(';');
    } else if (value instanceof Collection<?> all) {
      all.forEach(each -> add(each, leftOut, text));
      text.append(';');
    } else if (isPrinted(value)) {
      text.append(value).append(',');
    } else if (!value.getClass().isHidden()) {
      addFields(value, leftOut, text);
    }
  }

  private static boolean isPrinted(Object value) {
    return value == null
        || value instanceof Record
        || value instanceof Enum<?>
        || !value.getClass().getName().startsWith("org.starl.")
        || hasText(value);
  }

  private static boolean hasText(Object value) {
    try {
      return value.getClass().getMethod("toString").getDeclaringClass() != Object.class;
    } catch (NoSuchMethodException e) {
      throw new AssertionError(e);
    }
  }

  private static void addFields(Object object, Set<?> leftOut, StringBuilder text) {
    text.append('{');
    for (Field field : object.getClass().getDeclaredFields()) {
      boolean isLeftOut = leftOut.contains(field.getName()) || leftOut.contains(field.getType());
      if (!Modifier.isStatic(field.getModifiers()) && !isLeftOut) {
        add(get(field, object), leftOut, text);
      }
    }
    text.append('}');
  }

  private static Object get(Field field, Object object) {
    try {
      field.setAccessible(true);
      return field.get(object);
    } catch (IllegalAccessException e) {
      throw new AssertionError(e);
    }
  }
}
