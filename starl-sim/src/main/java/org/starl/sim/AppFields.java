package org.starl.sim;

import java.lang.reflect.Field;
import java.lang.reflect.Modifier;
import java.util.ArrayList;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.starl.RobotApp;

/** The objects in an app's own fields: most of its actions use them. */
final class AppFields {

  private static final ClassValue<List<Field>> FIELDS =
      new ClassValue<>() {
        @Override
        protected List<Field> computeValue(Class<?> app) {
          return fields(app);
        }
      };

  private AppFields() {}

  /** The present values of the fields that the app's class and its superclasses declare. */
  static Object[] of(RobotApp app) {
    List<Object> objects = new ArrayList<>();
    for (Field field : FIELDS.get(app.getClass())) {
      Object object = valueOf(field, app);
      if (object != null) {
        objects.add(object);
      }
    }
    return objects.toArray();
  }

  private static @Nullable Object valueOf(Field field, RobotApp app) {
    try {
      return field.get(app);
    } catch (IllegalAccessException e) {
      throw new IllegalStateException(field + " was made accessible", e);
    }
  }

  private static List<Field> fields(Class<?> app) {
    List<Field> fields = new ArrayList<>();
    for (Class<?> type = app; type.getSuperclass() != RobotApp.class; type = type.getSuperclass()) {
      for (Field field : type.getDeclaredFields()) {
        boolean isOwn = !Modifier.isStatic(field.getModifiers()) && !field.getType().isPrimitive();
        // A module that is not open keeps its fields.
        if (isOwn && field.trySetAccessible()) {
          fields.add(field);
        }
      }
    }
    return fields;
  }
}
