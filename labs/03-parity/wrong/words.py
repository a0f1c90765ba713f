# Diagnosis: return True or False
def parity(point, vertices):
    x, y = point
    is_inside = False
    for i, (qx, qy) in enumerate(vertices):
        px, py = vertices[i - 1]
        if (py > y) != (qy > y) and x < px + (y - py) / (qy - py) * (qx - px):
            is_inside = not is_inside
    return 'inside' if is_inside else 'outside'
