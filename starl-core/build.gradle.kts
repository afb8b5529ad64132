plugins {
    `java-library`
    id("maven-publish")
}

description = "Interface and logic layers: gvh, callStarL, motion automaton, ports"

dependencies {
    api(libs.jspecify)
    testImplementation(libs.junit.jupiter)
    testImplementation(libs.assertj.core)
    testImplementation(libs.jqwik)
    testRuntimeOnly(libs.junit.platform.launcher)
}
