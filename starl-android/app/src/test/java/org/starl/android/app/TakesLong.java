package org.starl.android.app;

/** The tag "long" for JUnit 4, where it is a category: {@code ./starl test} leaves these tests out. */
interface TakesLong {}
