# Diagnosis: level
def parity(point, vertices):
    x, y = point
    is_inside = False
    for i, (qx, qy) in enumerate(vertices):
        px, py = vertices[i - 1]
        if min(py, qy) <= y <= max(py, qy) and py != qy and x < px + (y - py) / (qy - py) * (qx - px):
            is_inside = not is_inside
    return is_inside
